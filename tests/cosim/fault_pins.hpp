// SPDX-License-Identifier: Apache-2.0
//
// Pins of a machine with two axes, which has faults at each sort of place.
#pragma once

#include "cosim/fault.hpp"

namespace trammel::test {

// `outputs` of each axis are gates, or bits of a code that can be stuck.
inline cosim::FaultPins two_axes(bool gates, int outputs = 6, int bits = 12) {
  using K = cosim::FaultKind;
  const K out = gates ? K::kGateDead : K::kOutputStuck;
  cosim::FaultPins pins;
  pins.axes = {"x", "y"};
  pins.places = {{K::kEncoderStuck, K::kEncoderStuck, 2, ""},
                 {K::kEncoderMissing, K::kIndexLost, 0, ""},
                 {K::kConverterStuck, K::kConverterSlipped, 2, ""},
                 {out, out, outputs, ""},
                 {K::kPhaseOpen, K::kPhaseOpen, 3, ""}};
  pins.inputs = {{0, 1, 2}, {3, 4, 5}};
  pins.converter_bits = bits;
  return pins;
}

}  // namespace trammel::test
