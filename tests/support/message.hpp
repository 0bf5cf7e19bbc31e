// SPDX-License-Identifier: Apache-2.0
//
// The message for what is refused.
#pragma once

#include <string>

#include "lab/layers.hpp"

namespace trammel::test {

// Of an act; "" when it is not refused.
template <class Error = host::ConfigError, class Act>
std::string refusal_of(Act&& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// Of a configuration; "" when it is accepted.
template <class Options>
std::string message_of(const std::string& toml) {
  return refusal_of([&] {
    Options options;
    lab::apply_text(options, toml, "some.toml", ".");
    lab::validate(options);
  });
}

}  // namespace trammel::test
