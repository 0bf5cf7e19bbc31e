// SPDX-License-Identifier: Apache-2.0
//
// Pins of mcafee_xy in the packed words of cosim.hpp; axis 0 is X, axis 1 is Y.
#pragma once

#include "cosim/cosim.hpp"
#include "models/pins/port.hpp"

namespace trammel::mcafee {

inline constexpr int kAxes = 2;

// sense(): encoder lines, the marker, which the part takes active low, and limit switches.
inline constexpr Port encoder_a{0, 1, kAxes, 3}, encoder_b{1, 1, kAxes, 3},
    marker{2, 1, kAxes, 3, true};
inline constexpr Port kLimitPins{6, 4};
inline constexpr int limit_low(int axis) { return kLimitPins(2 * axis); }
inline constexpr int limit_high(int axis) { return kLimitPins(2 * axis + 1); }

// drive(): a byte an axis for its converter, offset binary.
inline constexpr int converter(int axis) { return 8 * axis; }
inline constexpr cosim::Lines kZeroCode = 0x80;

inline constexpr cosim::Lines codes(cosim::Lines x, cosim::Lines y) {
  return x << converter(0) | y << converter(1);
}
inline constexpr cosim::Lines code(cosim::Lines drive, int axis) {
  return drive >> converter(axis) & 0xFF;
}

struct Pins {
  static constexpr cosim::Lines kIdle = 0;

  template <class In>
  static void sense(In& in, cosim::Lines lines) {
    encoder_a.put(in.enc_a_i, lines);
    encoder_b.put(in.enc_b_i, lines);
    marker.put(in.enc_idx_n_i, lines);
    kLimitPins.put(in.limit_i, lines);
  }
  template <class Out>
  static cosim::Lines drive(const Out& out) {
    return codes(out.dac_x_o, out.dac_y_o);
  }
};

}  // namespace trammel::mcafee
