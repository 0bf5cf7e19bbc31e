// SPDX-License-Identifier: Apache-2.0
//
// The message for a configuration that is refused.
#pragma once

#include <string>

#include "lab/layers.hpp"

namespace trammel::test {

// "" when it is accepted.
template <class Options>
std::string message_of(const std::string& toml) {
  Options options;
  try {
    lab::apply_text(options, toml, "some.toml", ".");
    lab::validate(options);
  } catch (const lab::ConfigError& error) {
    return error.what();
  }
  return "";
}

}  // namespace trammel::test
