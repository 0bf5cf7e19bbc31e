// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "lab/machines.hpp"
#include "lab/scenarios.hpp"

namespace trammel::test {

// The built-in scenarios of a machine, for programs that are linked with this machine alone.
inline std::vector<std::filesystem::path> scenarios_of(const lab::Machine& machine) {
  std::vector<std::filesystem::path> own;
  for (const auto& file : lab::scenarios()) {
    if (file.parent_path().parent_path().filename() == machine.name) own.push_back(file);
  }
  return own;
}

}  // namespace trammel::test
