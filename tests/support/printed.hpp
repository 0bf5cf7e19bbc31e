// SPDX-License-Identifier: Apache-2.0
//
// What is printed on stderr or stdout, for tests of what no exception or value carries.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <functional>
#include <string>

namespace trammel::test {

// What an act prints on a stream.
inline std::string printed_on(std::FILE* stream, const std::function<void()>& act) {
  std::FILE* const file = std::tmpfile();
  std::fflush(stream);
  const int before = dup(fileno(stream));
  dup2(fileno(file), fileno(stream));
  act();
  std::fflush(stream);
  dup2(before, fileno(stream));
  close(before);
  std::string text;
  std::rewind(file);
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  std::fclose(file);
  return text;
}

inline std::string on_stderr(const std::function<void()>& act) { return printed_on(stderr, act); }
inline std::string on_stdout(const std::function<void()>& act) { return printed_on(stdout, act); }

}  // namespace trammel::test
