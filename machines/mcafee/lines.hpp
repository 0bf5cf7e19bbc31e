// SPDX-License-Identifier: Apache-2.0
//
// Pin names of mcafee_xy in the packed words of cosim.hpp; axis 0 is X, axis 1 is Y.
#pragma once

#include "cosim/cosim.hpp"

namespace trammel::mcafee {

// sense(): encoder lines, the marker, which the part takes active low, and limit switches.
inline constexpr int encoder_a(int axis) { return 3 * axis; }
inline constexpr int encoder_b(int axis) { return 3 * axis + 1; }
inline constexpr int marker(int axis) { return 3 * axis + 2; }
inline constexpr int limit_low(int axis) { return 6 + 2 * axis; }
inline constexpr int limit_high(int axis) { return 7 + 2 * axis; }

// drive(): a byte an axis for its converter, offset binary.
inline constexpr int converter(int axis) { return 8 * axis; }
inline constexpr cosim::Lines kZeroCode = 0x80;

inline constexpr cosim::Lines code(cosim::Lines drive, int axis) {
  return drive >> converter(axis) & 0xFF;
}

}  // namespace trammel::mcafee
