// SPDX-License-Identifier: Apache-2.0
#include "testbench/streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>

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
  // Read only: what is written there fails as on a closed stream.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) == -1 && errno == EBADF) open("/dev/null", O_RDONLY);
  }
}

void print(const std::string& result) {
  if (refusal() != 0) return;
  remember(std::fwrite(result.data(), 1, result.size(), stdout) == result.size());
}

void tell(const std::string& message) {
  const std::string line = "trammel: " + message + '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

int settled(int code) {
  remember(std::fflush(stdout) == 0);
  if (refusal() == 0 || refusal() == EPIPE) return code;
  tell(std::string("standard output: cannot be written: ") + std::strerror(refusal()));
  return 2;
}

}  // namespace trammel::testbench
