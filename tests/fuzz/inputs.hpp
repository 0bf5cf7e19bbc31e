// SPDX-License-Identifier: Apache-2.0
//
// What the program reads, as functions of any bytes: each takes them or refuses them by the
// exception that is documented. Anything else ends the process, which is a finding.
#pragma once

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace trammel::fuzz {

// Prints what was found and ends the process.
[[noreturn]] void finding(const std::string& what);

// A message is one line of bounded length that a terminal can show; all else is a finding.
void check_message(const std::exception& error);

struct Target {
  std::string name;
  void (*run)(const std::string& bytes);
};
std::vector<Target> machine_targets();  // those of machines/<m>/tests/fuzz.cpp

class Inputs {
 public:
  // A scratch folder of this process is made in the working folder. `runs` has a folder of a
  // finished run of each machine.
  explicit Inputs(const std::filesystem::path& runs);
  ~Inputs();
  Inputs(const Inputs&) = delete;
  Inputs& operator=(const Inputs&) = delete;

  void try_one(const std::string& target, const std::string& bytes);

 private:
  void keys(const std::string& bytes);
  void scenario(const std::string& bytes);
  void folder(const std::string& bytes);

  std::filesystem::path scratch_;
  std::vector<std::filesystem::path> runs_;  // copies, one of each machine
};

}  // namespace trammel::fuzz
