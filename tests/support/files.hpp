// SPDX-License-Identifier: Apache-2.0
//
// What a file holds, for tests of files that a run writes.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace trammel::test {

inline std::string content(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace trammel::test
