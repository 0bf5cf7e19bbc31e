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

#include "machines/an693/verbs/console.hpp"
#include "machines/an693/verbs/script.hpp"

namespace trammel::an693 {
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

// libedit handles a stop and a resize once a line, and passes them on to us; so do the later ones.
volatile std::sig_atomic_t continued = 0, resized = 0;

void note(int signal) { (signal == SIGCONT ? continued : resized) = 1; }

// A key, or EOF at the end of input or when the line was interrupted, be it between two keys:
// libedit would know of that at the next one.
int read_key(FILE* in) {
  sigset_t heeded, before;  // let in while this waits: none comes between a look and the wait
  sigemptyset(&heeded);
  for (const int signal : {SIGCONT, SIGINT, SIGWINCH}) sigaddset(&heeded, signal);
  pthread_sigmask(SIG_BLOCK, &heeded, &before);
  pollfd input{fileno(in), POLLIN, 0};
  int key = EOF;
  while (!*interrupted) {
    if (continued != 0) {
      continued = 0;
      rl_prep_terminal(1);
      rl_forced_update_display();
    }
    if (resized != 0) {
      resized = 0;
      rl_resize_terminal();
    }
    unsigned char byte = 0;
    const bool is_there = ppoll(&input, 1, nullptr, &before) == 1;
    const ssize_t size = is_there ? read(input.fd, &byte, 1) : -1;
    if (size < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (size == 1 && byte >= 0x80) continue;  // no letter of any command; libedit has keys there
    if (size == 1) key = byte;
    break;
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return key;
}

}  // namespace

ReadLine terminal_lines(const std::atomic<bool>& stop) {
  interrupted = &stop;
  struct sigaction noted {};
  noted.sa_handler = note;
  sigaction(SIGCONT, &noted, nullptr);
  sigaction(SIGWINCH, &noted, nullptr);
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

}  // namespace trammel::an693
