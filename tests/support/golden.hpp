// SPDX-License-Identifier: Apache-2.0
//
// A text in tests/goldens, reviewed as a diff where it changes. scripts/tool gen-manual writes it.
#pragma once

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "lab/scenarios.hpp"
#include "tests/support/files.hpp"

namespace trammel::test {

inline std::filesystem::path golden_file(const std::string& name) {
  return lab::machine_folder("any").parent_path().parent_path() / "tests" / "goldens" / name;
}

inline void check_golden(const std::string& name, const std::string& text) {
  namespace fs = std::filesystem;
  const fs::path golden = golden_file(name);
  if (std::getenv("TRAMMEL_TEST_ACCEPT") != nullptr) {
    REQUIRE((std::ofstream(golden) << text).flush().good());
    return;
  }
  if (fs::exists(golden) && content(golden) == text) return;
  const fs::path now = fs::absolute(name);
  std::ofstream(now) << text;
  const std::string command = "diff -u " + golden.string() + ' ' + now.string() + " >&2";
  FAIL("diff says " << std::system(command.c_str())
                    << "; to accept the difference: scripts/tool gen-manual");
}

}  // namespace trammel::test
