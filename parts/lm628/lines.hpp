// SPDX-License-Identifier: Apache-2.0
//
// Pin names of the LM628 in the packed words of cosim.hpp, and of its host bus.
#pragma once

#include "cosim/cosim.hpp"

namespace trammel::lm628 {

// sense(): encoder lines, and the index pulse, which the part takes active low.
inline constexpr int kEncoderA = 0;
inline constexpr int kEncoderB = 1;
inline constexpr int kIndex = 2;

// drive(): the 12 bits that the converter holds, offset binary; a part in 8-bit mode never strobes.
inline constexpr cosim::Lines kZeroCode = 0x800;

}  // namespace trammel::lm628
