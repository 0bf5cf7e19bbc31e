// SPDX-License-Identifier: Apache-2.0
//
// What is said of a configuration that is refused.
#pragma once

#include <string>

#include "testbench/config.hpp"

namespace trammel::test {

// "" when it is taken.
template <class Options>
std::string message_of(const std::string& toml) {
  Options options;
  try {
    testbench::apply_text(options, toml, "some.toml", ".");
    testbench::finish(options);
  } catch (const testbench::ConfigError& error) {
    return error.what();
  }
  return "";
}

}  // namespace trammel::test
