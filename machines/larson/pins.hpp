// SPDX-License-Identifier: Apache-2.0
//
// Pins of the chip larson_xy in the packed words of cosim.hpp; axis 0 is X, axis 1 is Y.
#pragma once

#include "cosim/cosim.hpp"
#include "models/pins/port.hpp"

namespace trammel::larson {

inline constexpr int kAxes = 2;

// sense()
inline constexpr Port limit_low{0, 1, kAxes, 3}, limit_high{1, 1, kAxes, 3},
    buf_busy{2, 1, kAxes, 3};

// drive()
inline constexpr int kOutputs = 3;  // of an axis
inline constexpr Port step{0, 1, kAxes, kOutputs}, forward{1, 1, kAxes, kOutputs},
    flush{2, 1, kAxes, kOutputs};

struct Pins {
  static constexpr cosim::Lines kIdle = 0;

  template <class In>
  static void sense(In& in, cosim::Lines lines) {
    limit_low.put(in.limit_low_i, lines);
    limit_high.put(in.limit_high_i, lines);
    buf_busy.put(in.buf_busy_i, lines);
  }
  template <class Out>
  static cosim::Lines drive(const Out& out) {
    return step.lines(out.step_o) | forward.lines(out.forward_o) | flush.lines(out.flush_o);
  }
};

}  // namespace trammel::larson
