// SPDX-License-Identifier: Apache-2.0
//
// A program that draws or converts files of a run, joined by a pipe. It is in a process group of
// its own: a Ctrl-C, or a signal to all programs of ours, lets it end its file, so that a run that
// is interrupted keeps a whole record.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace trammel::host {

class Child {
 public:
  enum class Pipe { kToInput, kFromOutput };

  // Its other streams are /dev/null. `words` begins with the program's file.
  Child(const std::vector<std::string>& words, Pipe pipe,
        const std::filesystem::path& folder = ".");
  ~Child() { ended(); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  std::FILE* pipe() const { return pipe_; }  // null: it could not be started
  bool ended();  // closes the pipe and waits; whether its exit code was 0

 private:
  std::FILE* pipe_ = nullptr;
  pid_t id_ = -1;
};

}  // namespace trammel::host
