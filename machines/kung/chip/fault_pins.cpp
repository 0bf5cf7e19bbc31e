// SPDX-License-Identifier: Apache-2.0
//
// The pins of the chip at which faults can be.
#include <fmt/format.h>

#include "host/errors.hpp"
#include "machines/kung/chip/pins.hpp"
#include "machines/kung/options.hpp"

namespace trammel::kung {

cosim::FaultPins fault_pins(const Options& options) {
  using K = cosim::FaultKind;
  cosim::FaultPins pins;
  pins.axes = {"X", "Y"};
  pins.places = {{K::kEncoderStuck, K::kEncoderStuck, 2, "encoder: A, B"},
                 {K::kEncoderMissing, K::kTripPin, 0, ""},
                 {K::kConverterStuck, K::kConverterSlipped, 2, "converter: phase a, b"},
                 {K::kGateDead, K::kGateDead, 6, "gate: upper a, b, c, lower a, b, c"},
                 {K::kProcessorHung, K::kProcessorHung, 0, ""},
                 {K::kPhaseOpen, K::kPhaseOpen, 3, "phase: a, b, c"}};
  pins.trip = kTripPin;
  for (int axis = 0; axis < kAxes; ++axis) {
    pins.inputs.push_back({encoder_a(axis), encoder_b(axis), encoder_z(axis)});
  }
  pins.converter_bits = options.plant.axis[static_cast<std::size_t>(options.fault.axis)].adc_bits;
  return pins;
}

// Times of faults that are kinds of inject.fault now; 0 was never.
std::vector<lab::FormerKey> former_keys() {
  const auto one = [](const char* name, cosim::FaultKind kind) {
    lab::FormerKey former;
    former.key.name = name;
    former.key.max = 3600;
    former.now = [name, kind](const lab::Settings& settings,
                              const lab::Value& value) -> std::vector<std::string> {
      const double begin_s = std::get<double>(value);
      const cosim::Fault& fault = settings.fault;
      const auto word = [](cosim::FaultKind of) {
        return cosim::fault_words()[static_cast<std::size_t>(of)];
      };
      if (begin_s == 0 && fault.kind != kind) return {};
      if (begin_s == 0) return {"inject.fault=none"};
      if (fault.any() && fault.kind != kind) {
        throw host::ConfigError(fmt::format(
            "{}: value {:g} is the fault {} at that time, and inject.fault is {}: a run has one "
            "fault; set inject.fault alone", name, begin_s, word(kind), word(fault.kind)));
      }
      return {"inject.fault=" + word(kind), fmt::format("inject.begin_s={}", begin_s)};
    };
    return former;
  };
  return {one("inject.trip_s", cosim::FaultKind::kTripPin),
          one("inject.encoder_s", cosim::FaultKind::kEncoderJump),
          one("inject.processor_s", cosim::FaultKind::kProcessorHung)};
}

}  // namespace trammel::kung
