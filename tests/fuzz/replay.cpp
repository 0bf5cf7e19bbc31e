// SPDX-License-Identifier: Apache-2.0
//
// The fuzzers without libFuzzer, for the sanitized build of the tests: seeds, and random changes of
// them. The same seed gives the same cases. Of a case that ends it, the input is in `last-input`.
//
// usage: trammel_fuzz_replay TARGET CASES SEED RUNS SEEDS WORDS
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/inputs.hpp"

namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Mutator {
 public:
  Mutator(unsigned seed, std::vector<std::string> seeds, std::vector<std::string> words)
      : random_(seed), seeds_(std::move(seeds)), words_(std::move(words)) {}

  std::string next() {
    std::string text = one_of(seeds_);
    for (std::size_t count = below(5); count > 0; --count) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t most) { return random_() % most; }
  const std::string& one_of(const std::vector<std::string>& all) { return all[below(all.size())]; }

  void change(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    switch (below(6)) {
      case 0: text.insert(at, one_of(words_)); break;
      case 1: text.erase(at, 1 + below(20)); break;
      case 2: text.insert(at, 1, static_cast<char>(below(256))); break;
      case 3: text.resize(at); break;
      case 4: text.insert(at, one_of(seeds_), 0, below(100)); break;
      default: {
        const std::string part = text.substr(at, 1 + below(8));
        for (std::size_t count = below(40); count > 0; --count) text.insert(at, part);
      }
    }
  }

  std::mt19937 random_;
  std::vector<std::string> seeds_, words_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 7) {
    std::fputs("usage: trammel_fuzz_replay TARGET CASES SEED RUNS SEEDS WORDS\n", stderr);
    return 2;
  }
  const std::string target = argv[1];
  const int cases = std::atoi(argv[2]);
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(argv[5])) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> seeds, words;
  for (const fs::path& file : files) seeds.push_back(content(file));
  std::ifstream list(argv[6], std::ios::binary);
  for (std::string word; std::getline(list, word, '\0');) words.push_back(word);
  Mutator mutator(static_cast<unsigned>(std::atoi(argv[3])), seeds, words);
  trammel::fuzz::Inputs inputs(argv[4]);
  for (int k = 0; k < cases; ++k) {
    const auto n = static_cast<std::size_t>(k);
    const std::string bytes = n < seeds.size() ? seeds[n] : mutator.next();
    std::ofstream("last-input", std::ios::binary) << bytes;
    inputs.try_one(target, bytes);
  }
  return 0;
}
