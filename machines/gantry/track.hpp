// SPDX-License-Identifier: Apache-2.0
//
// The track's velocity [mm/s], 10 ms a step, by the mean force of both motors [count]: identified
// from a run with a pseudo-random force. `build/tests/gantry_identify_test -s` makes it and prints
// these numbers.
#pragma once

#include "models/ideal/kalman.hpp"

namespace trammel::gantry {

inline ideal::LinearModel<3> stored_track() {
  ideal::LinearModel<3> m;
  m.phi << 1.04261106, 1, 0, -0.265363574, 0, 1, 0.0426169088, 0, 0;
  m.psi << 0.110512024, -0.0319995673, -0.000526254781;
  m.c << 1, 0, 0;
  return m;
}

}  // namespace trammel::gantry
