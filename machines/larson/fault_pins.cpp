// SPDX-License-Identifier: Apache-2.0
//
// The pins of the chip at which faults can be.
#include "machines/larson/options.hpp"
#include "machines/larson/pins.hpp"

namespace trammel::larson {

cosim::FaultPins fault_pins(const Options&) {
  using K = cosim::FaultKind;
  cosim::FaultPins pins;
  pins.axes = {"X", "Y"};
  pins.places = {{K::kEncoderStuck, K::kEncoderStuck, 2, "limit switch: low, high"},
                 {K::kEncoderSwapped, K::kIndexLost, 0, ""},
                 {K::kOutputStuck, K::kOutputStuck, kOutputs, "output: step, direction, flush"},
                 {K::kPhaseOpen, K::kPhaseOpen, 1, "phase"}};
  for (int axis = 0; axis < kAxes; ++axis) {
    pins.inputs.push_back({limit_low(axis), limit_high(axis), buf_busy(axis)});
  }
  return pins;
}

}  // namespace trammel::larson
