// SPDX-License-Identifier: Apache-2.0
//
// What a user can do wrong, as exceptions; the text is one line that names what, where, and what is
// permitted.
#pragma once

#include <stdexcept>

namespace trammel::host {

// Files, keys, folders and command lines. Exit code 2.
struct ConfigError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A program that is needed is not installed. Exit code 3.
struct ToolMissing : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace trammel::host
