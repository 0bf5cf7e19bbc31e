// SPDX-License-Identifier: Apache-2.0
//
// Lines that are typed. With libedit, through its interface of readline: BSD licence. Its callbacks
// take no context, so what they need is static here. Without it, lines as the terminal edits them.
#ifdef TRAMMEL_EDIT
#include <editline/readline.h>
#endif
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "machines/an693/verbs/script.hpp"
#include "machines/an693/verbs/verbs.hpp"
#include "testbench/streams.hpp"

namespace trammel::an693 {
namespace {

#ifdef TRAMMEL_EDIT
// The words that may stand where `text` was begun, one a call; the first call has the state 0.
char* next_word(const char* text, int state) {
  static std::vector<std::string> words;
  if (state == 0) {
    const std::size_t begin = static_cast<std::size_t>(rl_point) - std::strlen(text);
    words = completions({rl_line_buffer, begin}, text);
  }
  if (words.empty()) return nullptr;
  char* const word = strdup(words.back().c_str());
  words.pop_back();
  return word;
}

#endif

const std::atomic<bool>* interrupted = nullptr;

// libedit handles a stop and a resize once a line, and passes them on to us; so do the later ones.
volatile std::sig_atomic_t disturbed = 0;

void note(int) { disturbed = 1; }

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
    if (disturbed != 0) {
      disturbed = 0;
#ifdef TRAMMEL_EDIT
      rl_prep_terminal(1);
      rl_resize_terminal();
      rl_forced_update_display();
#endif
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
#ifdef TRAMMEL_EDIT
  rl_getc_function = read_key;
  rl_completion_entry_function = next_word;
  rl_initialize();
  using_history();
  return [](const std::string& prompt) -> std::optional<std::string> {
    const std::unique_ptr<char, void (*)(void*)> line(readline(prompt.c_str()), std::free);
    if (line == nullptr) return {};
    if (*line != '\0') add_history(line.get());
    return std::string(line.get());
  };
#else
  testbench::tell("the prompt has no history and no completion: libedit is missing (see `trammel "
                  "doctor`)");
  return [](const std::string& prompt) -> std::optional<std::string> {
    testbench::print_now(prompt);
    std::string line;
    for (int key = read_key(stdin); key != '\n'; key = read_key(stdin)) {
      if (key == EOF) return {};
      line += static_cast<char>(key);
    }
    return line;
  };
#endif
}

}  // namespace trammel::an693
