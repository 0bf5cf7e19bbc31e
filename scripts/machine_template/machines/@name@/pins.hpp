// SPDX-License-Identifier: Apache-2.0
//
// Pins between @name@_pwm and the plant, in the packed words of cosim.hpp.
#pragma once

namespace trammel::@name@ {

// sense()
inline constexpr int kEncoderA = 0;
inline constexpr int kEncoderB = 1;

// drive()
inline constexpr int kPwm = 0;
inline constexpr int kDirection = 1;  // 1: backward

}  // namespace trammel::@name@
