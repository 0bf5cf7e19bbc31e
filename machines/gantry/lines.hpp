// SPDX-License-Identifier: Apache-2.0
//
// Pin names of the chip gantry_tau in the packed words of cosim.hpp; motor 0 is the thesis'
// motor 1.
#pragma once

#include "cosim/cosim.hpp"

namespace trammel::gantry {

inline constexpr int kMotors = 2;

// sense()
inline constexpr int kRx = 0;  // serial line to the chip; high at rest
inline constexpr int overtemp(int motor) { return 1 + motor; }

// drive()
inline constexpr int pwm(int motor) { return motor; }
inline constexpr int negative(int motor) { return 2 + motor; }  // toward the left
inline constexpr int kTx = 4;                                   // serial line from the chip

inline constexpr bool level(cosim::Lines lines, int line) { return (lines >> line & 1) != 0; }

// sample(): channels of the converter, codes 0 to 1023 for 0 to 5 V.
enum Channel : int { kA = 0, kADot = 1, kB = 2, kBDot = 3, kCurrent = 6 };

}  // namespace trammel::gantry
