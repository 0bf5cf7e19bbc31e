// SPDX-License-Identifier: Apache-2.0
//
// What the program makes of a standard output that takes no more; tests/system/files_test.py has
// whole programs.
#include "testbench/streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>

#include "tests/support/told.hpp"

using namespace trammel;
using Catch::Contains;

// Ahead of the next case: of a stream that takes no more nothing is asked again.
TEST_CASE("of a result no control character reaches a terminal, lines and columns do") {
  CHECK(test::printed([] { testbench::print("a\x1b[31m\n\tb\r\x7f\n"); }) ==
        "a\\u001b[31m\n\tb\\u000d\\u007f\n");
}

TEST_CASE("a result that standard output does not take makes the exit code 2, with its reason") {
  testbench::guard_streams();
  CHECK(testbench::settled(5) == 5);
  const int before = dup(STDOUT_FILENO);
  const int full = open("/dev/full", O_WRONLY);
  dup2(full, STDOUT_FILENO);
  int code = 0;
  const std::string told = test::told([&] {
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

TEST_CASE("messages are one line each, and the first of many warnings are told") {
  CHECK(test::told([] { testbench::tell("a\x1b\nb"); }) == "trammel: a\\u001b\\u000ab\n");
  const std::vector<std::string> five{"1", "2", "3", "4", "5"};
  CHECK(test::told([&] { testbench::tell_warnings("a", five); }) ==
        "trammel: a: 1\ntrammel: a: 2\ntrammel: a: 3\ntrammel: a: 4\ntrammel: a: 5\n");
  std::vector<std::string> seven = five;
  seven.insert(seven.end(), {"6", "7"});
  CHECK(test::told([&] { testbench::tell_warnings("a", seven); }) ==
        "trammel: a: 1\ntrammel: a: 2\ntrammel: a: 3\ntrammel: a: 4\ntrammel: a: 5\n"
        "trammel: a: and 2 more such warnings\n");
}
