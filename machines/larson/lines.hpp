// SPDX-License-Identifier: Apache-2.0
//
// Pin names of the chip larson_xy in the packed words of cosim.hpp; axis 0 is X, axis 1 is Y.
#pragma once

#include "cosim/cosim.hpp"

namespace trammel::larson {

// sense()
inline constexpr int limit_low(int axis) { return 3 * axis; }
inline constexpr int limit_high(int axis) { return 3 * axis + 1; }
inline constexpr int buf_busy(int axis) { return 3 * axis + 2; }

// drive()
inline constexpr int kOutputs = 3;  // of an axis
inline constexpr int step(int axis) { return kOutputs * axis; }
inline constexpr int forward(int axis) { return kOutputs * axis + 1; }
inline constexpr int flush(int axis) { return kOutputs * axis + 2; }

inline constexpr bool level(cosim::Lines lines, int line) { return (lines >> line & 1) != 0; }

}  // namespace trammel::larson
