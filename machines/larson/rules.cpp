// SPDX-License-Identifier: Apache-2.0
//
// Rules that concern more than one key.
#include <fmt/format.h>

#include "machines/larson/machine_members.hpp"

namespace trammel::larson {
namespace {

// A table cannot stand behind its stops.
void refuse_start(const Options& options, const char* key, double start) {
  const plant::StepperAxisConfig& axis = options.axis;
  const double low = plant::StepperAxis::low_stop(axis);
  const double high = plant::StepperAxis::high_stop(axis);
  if (start >= low && start <= high) return;
  throw host::ConfigError(fmt::format(
      "{}: {:g} is behind the stop at {:g}, axis.overtravel_step and axis.switch_hysteresis_step "
      "beyond its switch; permitted: {:g} to {:g}",
      key, start, start < low ? low : high, low, high));
}

}  // namespace

void validate(lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  const plant::StepperConfig& m = options.axis.motor;
  // What steps of 25 us follow.
  const double rate = m.friction / (m.friction_speed * m.inertia * 6.283185307179586 / m.steps);
  constexpr double kFastest = 6e4;  // [1/s]
  if (rate > kFastest) {
    throw host::ConfigError(fmt::format(
        "motor.friction_N_m / (motor.friction_speed_step_s motor.inertia_kg_m2): {:.3g} 1/s is "
        "above {:.3g} 1/s, the fastest that the motor's steps of 25 us can follow",
        rate, kFastest));
  }
  refuse_start(options, "axis.start_x_step", options.start_x);
  refuse_start(options, "axis.start_y_step", options.start_y);
  calls_of(options);
}

std::vector<Call> calls_of(const Options& options) {
  PlotSetup plot = options.plot;
  plot.soft_end = options.table.soft_end;
  return read_calls(options.script, plot, options.run.clock_ps);
}

}  // namespace trammel::larson
