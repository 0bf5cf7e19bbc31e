// SPDX-License-Identifier: Apache-2.0
//
// The pins of the chip at which faults can be.
#include "machines/mcafee/options.hpp"
#include "machines/mcafee/pins.hpp"

namespace trammel::mcafee {

cosim::FaultPins fault_pins(const Options&) {
  using K = cosim::FaultKind;
  cosim::FaultPins pins;
  pins.axes = {"X", "Y"};
  pins.places = {{K::kEncoderStuck, K::kEncoderStuck, 2, "encoder: A, B"},
                 {K::kEncoderMissing, K::kIndexLost, 0, ""},
                 {K::kOutputStuck, K::kOutputStuck, 8, "output: bit of the converter's code"},
                 {K::kPhaseOpen, K::kPhaseOpen, 1, "winding"}};
  for (int axis = 0; axis < kAxes; ++axis) {
    pins.inputs.push_back({encoder_a(axis), encoder_b(axis), marker(axis)});
  }
  return pins;
}

}  // namespace trammel::mcafee
