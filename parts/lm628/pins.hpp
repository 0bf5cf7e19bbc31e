// SPDX-License-Identifier: Apache-2.0
//
// Pin names of the LM628 in the packed words of cosim.hpp, and of its host bus.
#pragma once

#include "cosim/cosim.hpp"
#include "models/pins/port.hpp"

namespace trammel::lm628 {

// sense(): encoder lines, and the index pulse, which the part takes active low.
inline constexpr int kEncoderA = 0;
inline constexpr int kEncoderB = 1;
inline constexpr int kIndex = 2;

// drive() of an LM628: what the converter holds, as 12 bits, offset binary. One of 12 bits takes
// them by the part's strobes, which a part in 8-bit mode never gives; one of 8 bits is at the port.
inline constexpr int kConverterBits = 12;
inline constexpr cosim::Lines kZeroCode = 0x800;

// drive() of an LM629: the pins of the H-bridge.
inline constexpr int kMagnitude = 0;
inline constexpr int kSign = 1;
inline constexpr int kBridgeLines = 2;

// What the converter asks of a linear amplifier; 1 is full scale.
inline double share_of_code(cosim::Lines code) {
  return (static_cast<double>(code) - static_cast<double>(kZeroCode)) / 2048;
}

// What an H-bridge gives at this moment, of its supply: while the magnitude is low it shorts the
// winding.
inline double share_of_pulse(cosim::Lines pins) {
  if (!level(pins, kMagnitude)) return 0;
  return level(pins, kSign) ? -1 : 1;
}

}  // namespace trammel::lm628
