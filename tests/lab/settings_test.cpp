// SPDX-License-Identifier: Apache-2.0
//
// What is suggested for a mistyped word: any one letter too many, too few or wrong still finds it.
#include "lab/settings.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

using namespace trammel;

TEST_CASE("a word with one letter left out, added or wrong is found among others") {
  const std::vector<std::string> words{"gains.feedforward", "path.kind", "plant.coulomb_N",
                                       "run.platform"};
  for (const std::string& word : words) {
    for (std::size_t at = 0; at < word.size(); ++at) {
      std::string less = word, more = word, wrong = word;
      less.erase(at, 1);
      more.insert(at, "#");
      wrong[at] = '#';
      for (const std::string& typed : {less, more, wrong}) {
        INFO("typed " << typed);
        CHECK(lab::suggest(typed, words) == word);
      }
    }
  }
}

TEST_CASE("two letters left out side by side are still that word, half of it is another") {
  const std::vector<std::string> words{"plant.coulomb_N", "run.platform"};
  CHECK(lab::suggest("plantcoulomb", {"plant.coulomb_N"}) == "plant.coulomb_N");
  for (std::size_t at = 0; at + 2 <= words[0].size(); ++at) {
    std::string less = words[0];
    less.erase(at, 2);
    INFO("typed " << less);
    CHECK(lab::suggest(less, words) == words[0]);
  }
  CHECK(lab::suggest("coulomb_N", words) == "");
}
