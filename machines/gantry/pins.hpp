// SPDX-License-Identifier: Apache-2.0
//
// Pins of the chip gantry_tau in the packed words of cosim.hpp; motor 0 is the thesis' motor 1.
#pragma once

#include "cosim/cosim.hpp"
#include "models/pins/port.hpp"

namespace trammel::gantry {

inline constexpr int kMotors = 2;

// sense(): the serial line to the chip, high at rest, and hot bridges.
inline constexpr int kRx = 0;
inline constexpr Port overtemp{1, kMotors};

// drive(): bridges, negative toward the left, and the serial line from the chip.
inline constexpr Port pwm{0, kMotors}, negative{2, kMotors};
inline constexpr int kTx = 4;

struct Pins {
  static constexpr cosim::Lines kIdle = cosim::Lines{1} << kRx;

  template <class In>
  static void sense(In& in, cosim::Lines lines) {
    Port{kRx}.put(in.rx_i, lines);
    overtemp.put(in.overtemp_i, lines);
  }
  template <class Out>
  static cosim::Lines drive(const Out& out) {
    return pwm.lines(out.pwm_o) | negative.lines(out.negative_o) | Port{kTx}.lines(out.tx_o);
  }
};

// sample(): channels of the converter, codes 0 to 1023 for 0 to 5 V.
enum Channel : int { kA = 0, kADot = 1, kB = 2, kBDot = 3, kCurrent = 6 };

}  // namespace trammel::gantry
