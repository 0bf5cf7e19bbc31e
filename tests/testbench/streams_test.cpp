// SPDX-License-Identifier: Apache-2.0
//
// What the program makes of a standard output that takes no more; tests/system/files_test.py has
// whole programs.
#include "testbench/streams.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>

#include "tests/support/printed.hpp"

using namespace trammel;
using Catch::Contains;

// These are first: of a stream that takes no more nothing is asked again.
TEST_CASE("of a result no control character reaches a terminal, lines and columns do") {
  CHECK(test::on_stdout([] { testbench::print("a\x1b[31m\n\tb\r\x7f\n"); }) ==
        "a\\u001b[31m\n\tb\\u000d\\u007f\n");
}

TEST_CASE("what is printed now is there at once") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  std::fflush(stdout);
  const int before = dup(STDOUT_FILENO);
  dup2(ends[1], STDOUT_FILENO);
  testbench::print("a");
  testbench::print_now("b");
  char seen[8] = {};
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  const ssize_t count = read(ends[0], seen, sizeof seen);
  dup2(before, STDOUT_FILENO);
  for (const int end : {before, ends[0], ends[1]}) close(end);
  CHECK(count == 2);
  CHECK(std::string(seen) == "ab");
}

TEST_CASE("a result that standard output does not take makes the exit code 2, with its reason") {
  testbench::guard_streams();
  CHECK(testbench::settled(5) == 5);
  const int before = dup(STDOUT_FILENO);
  const int full = open("/dev/full", O_WRONLY);
  dup2(full, STDOUT_FILENO);
  int code = 0;
  const std::string told = test::on_stderr([&] {
    testbench::print("a result\n");
    code = testbench::settled(0);
    testbench::print("another\n");
  });
  std::clearerr(stdout);
  dup2(before, STDOUT_FILENO);
  close(before);
  close(full);
  CHECK(code == 2);
  CHECK(told ==
        "trammel: standard output: cannot be written: No space left on device\n");
}

TEST_CASE("a stream that is closed is one that takes and gives nothing, others stay") {
  for (const int closed : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO, -1}) {
    CAPTURE(closed);
    const pid_t child = fork();
    if (child == 0) {
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        dup2(open("/dev/zero", O_RDWR), stream);
      }
      if (closed >= 0) close(closed);
      testbench::guard_streams();
      bool good = true;
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        std::error_code error;
        const auto file = std::filesystem::read_symlink(
            "/proc/self/fd/" + std::to_string(stream), error);
        const int way = fcntl(stream, F_GETFL) & O_ACCMODE;
        const int none = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
        good = good && !error && file == (stream == closed ? "/dev/null" : "/dev/zero") &&
               way == (stream == closed ? none : O_RDWR);
      }
      _exit(good ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(status == 0);
  }
}

TEST_CASE("messages are one line each, and the first of many warnings are told") {
  CHECK(test::on_stderr([] { testbench::tell("a\x1b\nb"); }) == "trammel: a\\u001b\\u000ab\n");
  const std::vector<std::string> five{"1", "2", "3", "4", "5"};
  CHECK(test::on_stderr([&] { testbench::tell_warnings("a", five); }) ==
        "trammel: a: 1\ntrammel: a: 2\ntrammel: a: 3\ntrammel: a: 4\ntrammel: a: 5\n");
  std::vector<std::string> seven = five;
  seven.insert(seven.end(), {"6", "7"});
  CHECK(test::on_stderr([&] { testbench::tell_warnings("a", seven); }) ==
        "trammel: a: 1\ntrammel: a: 2\ntrammel: a: 3\ntrammel: a: 4\ntrammel: a: 5\n"
        "trammel: a: and 2 more such warnings\n");
}
