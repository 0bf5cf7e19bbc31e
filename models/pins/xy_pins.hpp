// SPDX-License-Identifier: Apache-2.0
//
// Pins of a two-axis table with vector-controlled motors, in packed words: of its plant, and of the
// chip that drives it. Axis 0 is X, 1 is Y.
#pragma once

#include <cstdint>

#include "models/pins/port.hpp"

namespace trammel::xy {

inline constexpr int kAxes = 2;

// The table drives these, and its processor the trip.
inline constexpr Port encoder_a{0, 1, kAxes, 3}, encoder_b{1, 1, kAxes, 3},
    encoder_z{2, 1, kAxes, 3};
inline constexpr int kTripPin = 6;

// Of the chip, and of each top that has it inside.
template <class Top>
void sense_encoders(Top& top, std::uint64_t lines) {
  encoder_a.put(top.enc_a_i, lines);
  encoder_b.put(top.enc_b_i, lines);
  encoder_z.put(top.enc_z_i, lines);
}

// The chip drives these: three phases an axis, whose upper gates are before the lower ones.
inline constexpr Port kGatesHi{0, 3, kAxes, 6}, kGatesLo{3, 3, kAxes, 6};
constexpr int gate_hi(int axis, int phase) { return kGatesHi(3 * axis + phase); }
constexpr int gate_lo(int axis, int phase) { return kGatesLo(3 * axis + phase); }
constexpr std::uint64_t gates(unsigned hi, unsigned lo) {
  return kGatesHi.lines(hi) | kGatesLo.lines(lo);
}
constexpr unsigned axis_gates(std::uint64_t drive, int axis) {
  return static_cast<unsigned>(drive >> (6 * axis)) & 63u;
}

// Channels of the converters, phases a and b of an axis.
constexpr int adc_channel(int axis, int phase) { return 2 * axis + phase; }

}  // namespace trammel::xy
