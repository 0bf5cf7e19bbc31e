// SPDX-License-Identifier: Apache-2.0
//
// Pins of the chip kung_xy in the packed words of cosim.hpp: those of its table.
#pragma once

#include "cosim/cosim.hpp"
#include "models/pins/xy_lines.hpp"

namespace trammel::kung {

using xy::adc_channel;
using xy::encoder_a;
using xy::encoder_b;
using xy::encoder_z;
using xy::gate_hi;
using xy::gate_lo;
using xy::kAxes;
using xy::kTripPin;

// Of the chip, and of each top that has it inside.
template <class Top>
void sense_encoders(Top& top, cosim::Lines lines) {
  encoder_a.put(top.enc_a_i, lines);
  encoder_b.put(top.enc_b_i, lines);
  encoder_z.put(top.enc_z_i, lines);
}

inline cosim::Lines gates(unsigned hi, unsigned lo) {
  return xy::kGatesHi.lines(hi) | xy::kGatesLo.lines(lo);
}

}  // namespace trammel::kung
