// SPDX-License-Identifier: Apache-2.0
//
// Thrown by a program that has only the model for speed, see cmake/chips.cmake.
#pragma once

#include <stdexcept>

namespace trammel::cosim {

struct NotBuilt : std::runtime_error {
  NotBuilt()
      : std::runtime_error("this program has no models for waves, assertions and audits; "
                           "`./trammel run` builds them") {}
};

}  // namespace trammel::cosim
