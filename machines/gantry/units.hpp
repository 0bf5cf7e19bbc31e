// SPDX-License-Identifier: Apache-2.0
//
// Sizes of the chip's and the firmware's integers.
#pragma once

namespace trammel::gantry {

inline constexpr double kUnit_mm = 5.0 / 16384;                  // of position
inline constexpr double kVelocity_mm_s = kUnit_mm / 512 * 4612;  // of velocity
inline constexpr double kCount_mm = 5.0 / 32;                    // of control

}  // namespace trammel::gantry
