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
