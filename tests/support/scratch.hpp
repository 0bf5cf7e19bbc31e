// SPDX-License-Identifier: Apache-2.0
//
// A folder of one test in the build folder: empty at the start, gone at the end.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string>

#include "tests/support/variable.hpp"

namespace trammel::test {

struct Scratch {
  std::filesystem::path path;

  explicit Scratch(const std::string& name) : path(std::filesystem::absolute(name)) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~Scratch() { std::filesystem::remove_all(path); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

// The working folder, for as long as this lives.
class WorkingFolder {
 public:
  explicit WorkingFolder(const std::filesystem::path& folder)
      : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(folder);
  }
  ~WorkingFolder() { std::filesystem::current_path(before_); }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

 private:
  std::filesystem::path before_;
};

// No program is found, for as long as this lives: pictures take longer than the rest of a run.
class NoPrograms : public Variable {
 public:
  NoPrograms() : Variable("PATH", "/nowhere") {}
};

// A file in the working folder that no test beside this one has: cases run at once.
inline std::string own_file(const std::string& name) {
  return std::to_string(::getpid()) + '_' + name;
}

inline std::size_t entries(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace trammel::test
