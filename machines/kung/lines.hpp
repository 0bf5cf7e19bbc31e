// SPDX-License-Identifier: Apache-2.0
//
// Pin names of the two-axis chip kung_xy in the packed words of cosim.hpp. Axis 0 is X, 1 is Y.
#pragma once

#include "cosim/cosim.hpp"

namespace trammel::kung {

inline constexpr int kAxes = 2;

// sense(): per axis A, B, index; then the trip input.
constexpr int encoder_a(int axis) { return 3 * axis; }
constexpr int encoder_b(int axis) { return 3 * axis + 1; }
constexpr int encoder_z(int axis) { return 3 * axis + 2; }
inline constexpr int kTripPin = 6;

// drive(): gate_hi of phases A, B, C at bit 6*axis + phase, gate_lo three bits above.
constexpr int gate_hi(int axis, int phase) { return 6 * axis + phase; }
constexpr int gate_lo(int axis, int phase) { return 6 * axis + 3 + phase; }

// sample(): two-channel converter per axis, phases a and b; offset binary 0..4095, 2048 = 0 A.
constexpr int adc_channel(int axis, int phase) { return 2 * axis + phase; }

}  // namespace trammel::kung
