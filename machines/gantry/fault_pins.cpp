// SPDX-License-Identifier: Apache-2.0
//
// The pins of the chip at which faults can be.
#include "machines/gantry/options.hpp"
#include "machines/gantry/pins.hpp"

namespace trammel::gantry {

cosim::FaultPins fault_pins(const Options&) {
  using K = cosim::FaultKind;
  cosim::FaultPins pins;
  pins.axes = {"motor 1", "motor 2"};
  pins.places = {{K::kEncoderStuck, K::kEncoderStuck, 2,
                  "input: serial line to the chip, over-temperature of the motor"},
                 {K::kConverterStuck, K::kConverterSlipped, 2,
                  "converter: A for motor 1 or B for motor 2, its derivative"},
                 {K::kOutputStuck, K::kOutputStuck, 2,
                  "output for motor 1: PWM of motor 1, 2, for motor 2: direction of motor 1, 2"},
                 {K::kPhaseOpen, K::kPhaseOpen, 1, "winding"}};
  for (int motor = 0; motor < kMotors; ++motor) pins.inputs.push_back({kRx, overtemp(motor)});
  pins.converter_bits = 10;
  return pins;
}

}  // namespace trammel::gantry
