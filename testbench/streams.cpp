// SPDX-License-Identifier: Apache-2.0
#include "testbench/streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>

#include <nlohmann/json.hpp>

#include "host/text.hpp"

namespace trammel::testbench {
namespace {

// What standard output said when it first refused a result; 0: it took all of them.
int& refusal() {
  static int error = 0;
  return error;
}

void remember(bool good) {
  if (!good && refusal() == 0) refusal() = errno;
}

}  // namespace

void guard_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that is too large is an error of the write
  // The other way round: what is read or written there fails as on a closed stream.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

void print(const std::string& result) {
  if (refusal() != 0) return;
  const std::string text = host::printable_lines(result);
  remember(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

void print_now(const std::string& result) {
  print(result);
  remember(std::fflush(stdout) == 0);
}

void print_json(const nlohmann::ordered_json& document) {
  print(document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
}

void tell(const std::string& message) {
  const std::string line = "trammel: " + host::one_line(message) + '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void tell_warnings(const std::string& of, const std::vector<std::string>& warnings) {
  constexpr std::size_t kShown = 5;
  for (std::size_t k = 0; k < std::min(warnings.size(), kShown); ++k) {
    tell(of + ": " + warnings[k]);
  }
  if (warnings.size() <= kShown) return;
  tell(of + ": and " + std::to_string(warnings.size() - kShown) + " more such warnings");
}

int settled(int code) {
  remember(std::fflush(stdout) == 0);
  if (refusal() == 0 || refusal() == EPIPE) return code;
  tell(std::string("standard output: cannot be written: ") + std::strerror(refusal()));
  return 2;
}

}  // namespace trammel::testbench
