// SPDX-License-Identifier: Apache-2.0
//
// Pins of McAfee's machine in the packed words of cosim.hpp; axis 0 is X.
#pragma once

#include <cstddef>

#include "cosim/cosim.hpp"

namespace trammel::mcafee {

// sense(): encoder lines, the marker, which is low, and the limit switches.
constexpr int encoder_a(std::size_t axis) { return static_cast<int>(3 * axis); }
constexpr int encoder_b(std::size_t axis) { return static_cast<int>(3 * axis + 1); }
constexpr int index_n(std::size_t axis) { return static_cast<int>(3 * axis + 2); }
inline constexpr int kLimits = 6;  // X low, X high, Y low, Y high; 1 = reached

// drive(): codes of the 8-bit converters, offset binary.
inline constexpr cosim::Lines kZeroCodes = 0x8080;
constexpr unsigned code_of(cosim::Lines drive, std::size_t axis) {
  return static_cast<unsigned>(drive >> 8 * axis & 0xFF);
}

}  // namespace trammel::mcafee
