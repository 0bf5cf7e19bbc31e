// SPDX-License-Identifier: Apache-2.0
//
// libedit, through its interface of readline: BSD licence. Its callbacks take no context, so what
// they need is static here.
#include <editline/readline.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "testbench/lm628.hpp"
#include "testbench/lm628_script.hpp"

namespace trammel::testbench {
namespace {

// What may stand at that place and begins with `text`, in the case that it was begun in.
std::vector<std::string> candidates(const std::string& before, const std::string& text) {
  std::vector<std::string> words;
  if (before.empty() || before == "help ") {
    for (const Lm628Word& word : lm628_words()) words.emplace_back(word.name);
  } else if (before == "wait ") {
    words = {"hi", "complete"};
  } else if (before == "byte " || before == "read ") {
    words = {"c", "d"};
  }
  const bool small = !text.empty() && std::islower(static_cast<unsigned char>(text[0])) != 0;
  std::vector<std::string> fitting;
  for (std::string& word : words) {
    const auto same = [](char a, char b) {
      return std::tolower(static_cast<unsigned char>(a)) ==
             std::tolower(static_cast<unsigned char>(b));
    };
    if (text.size() > word.size() || !std::equal(text.begin(), text.end(), word.begin(), same)) {
      continue;
    }
    if (small) {
      for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    fitting.push_back(std::move(word));
  }
  return fitting;
}

std::vector<std::string>& offered() {
  static std::vector<std::string> words;
  return words;
}

char* next_offered(const char*, int state) {
  static std::size_t at = 0;
  if (state == 0) at = 0;
  return at < offered().size() ? strdup(offered()[at++].c_str()) : nullptr;
}

char** complete(const char* text, int start, int) {
  std::string before(rl_line_buffer, static_cast<std::size_t>(start));
  for (char& c : before) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  offered() = candidates(before, text);
  rl_attempted_completion_over = 1;  // no names of files
  return rl_completion_matches(text, next_offered);
}

}  // namespace

ReadLine terminal_lines() {
  rl_initialize();
  using_history();
  rl_attempted_completion_function = complete;
  return [](const std::string& prompt) -> std::optional<std::string> {
    const std::unique_ptr<char, void (*)(void*)> line(readline(prompt.c_str()), std::free);
    if (line == nullptr) return {};
    if (*line != '\0') add_history(line.get());
    return std::string(line.get());
  };
}

}  // namespace trammel::testbench
