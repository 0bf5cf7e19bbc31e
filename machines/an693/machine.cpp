// SPDX-License-Identifier: Apache-2.0
#include "machines/an693/machine_members.hpp"

#include <fmt/format.h>

#include "machines/an693/session.hpp"
#include "parts/lm628/columns.hpp"
#include "parts/lm628/motor.hpp"
#include "parts/lm628/signals.hpp"

namespace trammel::an693 {
namespace {

void validate(lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  lm628::check_part(options.part);
  lm628::check_motor(options.plant.motor);
  if (options.plant.counts % 4 != 0) {
    throw host::ConfigError(fmt::format("encoder.counts: value {} is not a multiple of 4",
                                        options.plant.counts));
  }
}

lab::Machine describe() {
  lab::Machine m;
  m.name = "an693";
  m.title = "LM628 motion controller with a DC motor, driven by the programs of AN-693";
  m.source = "National Semiconductor AN-693; data sheet SNVS781C";
  m.order = 2;
  m.of_types<Options, Session>();
  m.keys = keys;
  m.validate = validate;
  m.texts.warnings = [](const lab::Settings& settings) {
    const std::string text = lm628::part_warning(static_cast<const Options&>(settings).part);
    return text.empty() ? std::vector<std::string>{} : std::vector<std::string>{text};
  };
  m.traces.triggers = triggers;
  m.traces.vcd_bytes_s = 8.5e9;
  m.traces.fst_bytes_s = 3e7;
  m.columns = columns;
  m.figures = figures;
  m.verdict = lm628::verdict<Options, Result>;
  m.texts.remarks = remarks;
  m.files.metrics = add_metrics;
  m.page.numbers = {"/motion/samples", "/motion/time_s", "/options/encoder.counts"};
  m.page.arrays = {"/interrupts"};
  return m;
}

}  // namespace

const cosim::TriggerForms& triggers() {
  static const cosim::TriggerForms forms = cosim::stop_forms(lm628::signals(), lm628::kTriggerHelp);
  return forms;
}

const lab::Machine& machine() {
  static const lab::Machine description = describe();
  return description;
}

}  // namespace trammel::an693
