// SPDX-License-Identifier: Apache-2.0
//
// What is suggested for a mistyped word, values as text, what a run's heading says.
#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "lab/heading.hpp"
#include "lab/machine.hpp"
#include "lab/settings.hpp"

using namespace trammel;
using namespace trammel::lab;

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

TEST_CASE("a word is found in any case and by its beginning, a single letter is none") {
  CHECK(lab::suggest("PLANT.COULOMB_n", {"plant.coulomb_N"}) == "plant.coulomb_N");
  CHECK(lab::suggest("pl", {"gains.kp", "plant.coulomb_N"}) == "plant.coulomb_N");
  CHECK(lab::suggest("p", {"plant.coulomb_N"}) == "");
  CHECK(lab::suggest("fca", {"fc", "afc"}) == "fc");
  CHECK(lab::suggest("list", {"lint"}) == "lint");
  CHECK(lab::suggest("lost", {"lint"}) == "");  // half of a short word
  CHECK(lab::hint("lost", {"lint"}, "; none") == "; none");
  CHECK(lab::hint("linx", {"lint"}, "; none") == "; did you mean lint?");
}

TEST_CASE("a value is the text that TOML reads as the same value") {
  CHECK(lab::value_text(true) == "true");
  CHECK(lab::value_text(std::int64_t{-7}) == "-7");
  CHECK(lab::value_text(3.0) == "3.0");
  CHECK(lab::value_text(0.1) == "0.1");
  CHECK(lab::value_text(1e300) == "1e+300");
  CHECK(lab::value_text(std::numeric_limits<double>::infinity()) == "inf");
  CHECK(lab::value_text(std::nan("")) == "nan");
  CHECK(lab::value_text(std::string("a \"b\" \\ \n\x01\x7f")) ==
        "\"a \\\"b\\\" \\\\ \\u000A\\u0001\\u007F\"");
}

TEST_CASE("a heading names what is not its scenario's, three of them at most, axes together") {
  std::size_t tried = 0;
  for (const lab::Machine* const machine : lab::machines()) {
    if (machine->described.alters == nullptr) continue;
    std::vector<const lab::Key*> of_x;  // reals of both axes that alter it
    for (const lab::Key& key : machine->keys()) {
      if (key.kind == lab::Kind::kReal && key.name.find(".x.") != std::string::npos &&
          machine->described.alters(key, 0.5)) {
        of_x.push_back(&key);
      }
    }
    REQUIRE(of_x.size() >= 4);
    const auto settings = machine->defaults();
    const auto set = [&](const std::string& name, double value) {
      for (const lab::Key* const key : lab::find_keys(machine->keys(), name)) {
        const lab::Value before = key->get(*settings);
        key->set(*settings, value);
        if (lab::Value(value) != before) lab::note_change(*settings, *key, before);
      }
    };
    const auto own = [&](const std::string& name) {
      return std::get<double>(
          lab::find_keys(machine->keys(), name).front()->get(*machine->defaults()));
    };
    settings->description = "mine (a (b)) (Fig. 3)";
    settings->heading = {};
    const std::string one = of_x[0]->name, both = lab::short_form(one);
    const std::string begin = "mine (a (b)); here ";
    CAPTURE(machine->name, one);
    set(one, own(one) + 0.5);
    CHECK(settings->description.rfind(begin + one + " = ", 0) == 0);
    CHECK(settings->description.find(',') == std::string::npos);
    set(one, own(one) + 0.75);  // and again: still against the scenario's
    set(one, own(one));
    CHECK(settings->description == "mine (a (b)) (Fig. 3)");
    set(both, own(one) + 0.5);
    CHECK(settings->description.rfind(begin + both + " = ", 0) == 0);
    CHECK(settings->description.find(',') == std::string::npos);
    for (std::size_t k = 1; k < 4; ++k) set(of_x[k]->name, own(of_x[k]->name) + 0.5);
    CHECK_THAT(settings->description, Catch::EndsWith(" and 1 more"));
    CHECK_THAT(settings->description, Catch::Contains(of_x[2]->name + " = ") &&
                                          !Catch::Contains(of_x[3]->name + " = "));
    ++tried;
  }
  CHECK(tried > 0);
}
