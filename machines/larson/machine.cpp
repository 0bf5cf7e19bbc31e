// SPDX-License-Identifier: Apache-2.0
#include "machines/larson/machine.hpp"

#include <fmt/format.h>

#include "machines/larson/session.hpp"
#include "machines/larson/signals.hpp"

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

lab::Machine describe() {
  lab::Machine m;
  m.name = "larson";
  m.title = "X-Y stepper table of 1974: four words, pulse buffers, steppers that can lose steps";
  m.source = "Larson 1974";
  m.order = 4;
  m.of_types<Options, Session>();
  m.keys = keys;
  m.described.by = "script";
  m.validate = validate;
  m.traces.triggers = triggers;
  m.traces.vcd_bytes_s = 5e9;
  m.traces.fst_bytes_s = 1e7;
  m.columns = columns;
  m.figures = figures;
  m.texts.remarks = remarks;
  m.files.metrics = add_metrics;
  m.page.arrays = {"/events", "/calls"};
  return m;
}

}  // namespace

std::vector<Call> calls_of(const Options& options) {
  PlotSetup plot = options.plot;
  plot.soft_end = options.table.soft_end;
  return read_calls(options.script, plot, options.run.clock_ps);
}

const cosim::TriggerForms& triggers() {
  static const cosim::TriggerForms forms = cosim::stop_forms(signals(), kTriggerHelp);
  return forms;
}

const lab::Machine& machine() {
  static const lab::Machine description = describe();
  return description;
}

}  // namespace trammel::larson
