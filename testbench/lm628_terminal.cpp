// SPDX-License-Identifier: Apache-2.0
//
// libedit, through its interface of readline: BSD licence. Its callbacks take no context, so what
// they need is static here.
#include <editline/readline.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
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

const std::atomic<bool>* interrupted = nullptr;

// A key, or EOF at the end of input or when the line was interrupted. An interrupt is let in only
// while this waits: one that comes while libedit draws would be known at the next key.
int read_key(FILE* in) {
  sigset_t interrupts, before;
  sigemptyset(&interrupts);
  sigaddset(&interrupts, SIGINT);
  pthread_sigmask(SIG_BLOCK, &interrupts, &before);
  pollfd input{fileno(in), POLLIN, 0};
  unsigned char byte = 0;
  bool is_read = false;
  while (!*interrupted) {
    const int ready = ppoll(&input, 1, nullptr, &before);
    if (ready < 0 && errno == EINTR) continue;
    is_read = ready == 1 && read(input.fd, &byte, 1) == 1;
    break;
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return is_read ? byte : EOF;
}

}  // namespace

ReadLine terminal_lines(const std::atomic<bool>& stop) {
  interrupted = &stop;
  rl_getc_function = read_key;
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
