// SPDX-License-Identifier: Apache-2.0
//
// Pins of the chip kung_xy in the packed words of cosim.hpp: those of its table.
#pragma once

#include "cosim/cosim.hpp"
#include "models/pins/xy_pins.hpp"

namespace trammel::kung {

using xy::adc_channel;
using xy::encoder_a;
using xy::encoder_b;
using xy::encoder_z;
using xy::gate_hi;
using xy::gate_lo;
using xy::gates;
using xy::kAxes;
using xy::kTripPin;
using xy::sense_encoders;

}  // namespace trammel::kung
