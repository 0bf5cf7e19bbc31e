// SPDX-License-Identifier: Apache-2.0
//
// What is printed on stderr, for tests of messages that no exception carries.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <functional>
#include <string>

namespace trammel::test {

inline std::string told(const std::function<void()>& act) {
  std::FILE* const file = std::tmpfile();
  std::fflush(stderr);
  const int before = dup(STDERR_FILENO);
  dup2(fileno(file), STDERR_FILENO);
  act();
  std::fflush(stderr);
  dup2(before, STDERR_FILENO);
  close(before);
  std::string text;
  std::rewind(file);
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  std::fclose(file);
  return text;
}

}  // namespace trammel::test
