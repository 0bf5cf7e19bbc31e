// SPDX-License-Identifier: Apache-2.0
//
// The pins of the chip at which faults can be.
#include "machines/kung/chip/lines.hpp"
#include "machines/kung/options.hpp"

namespace trammel::kung {

cosim::FaultPins fault_pins(const Options& options) {
  using K = cosim::FaultKind;
  cosim::FaultPins pins;
  pins.axes = {"X", "Y"};
  pins.places = {{K::kEncoderStuck, K::kEncoderStuck, 2, "encoder: A, B"},
                 {K::kEncoderMissing, K::kIndexLost, 0, ""},
                 {K::kConverterStuck, K::kConverterSlipped, 2, "converter: phase a, b"},
                 {K::kGateDead, K::kGateDead, 6, "gate: upper a, b, c, lower a, b, c"},
                 {K::kPhaseOpen, K::kPhaseOpen, 3, "phase: a, b, c"}};
  for (int axis = 0; axis < kAxes; ++axis) {
    pins.inputs.push_back({encoder_a(axis), encoder_b(axis), encoder_z(axis)});
  }
  pins.converter_bits = options.plant.axis[static_cast<std::size_t>(options.fault.axis)].adc_bits;
  return pins;
}

}  // namespace trammel::kung
