// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/machine.hpp"

#include <fmt/format.h>

#include "machines/mcafee/session.hpp"
#include "parts/lm628/columns.hpp"
#include "parts/lm628/motor.hpp"

namespace trammel::mcafee {
namespace {

constexpr int kMostFeed = 254;  // what the feed rate gives at most

std::string name_of(int speed) { return fmt::format("v = {}", speed); }

void validate(lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  lm628::check_clock(options.clock_MHz);
  lm628::check_motor(options.stage_axis.motor);
  if (options.tracks()) table_of(options);
}

// The same path at constant speeds.
std::vector<lab::Companion> companions(const lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  std::vector<lab::Companion> all;
  if (!options.tracks() || !options.compare) return all;
  for (const int speed : {kMostFeed, options.least_speed}) {
    auto other = std::make_unique<Options>(options);
    other->speed = speed;
    other->run.wave = cosim::WaveFormat::kNone;  // waves are of the first
    all.push_back({name_of(speed), std::move(other)});
  }
  return all;
}

lab::Machine describe() {
  lab::Machine m;
  m.name = "mcafee";
  m.title = "two LM628 and a fuzzy feed rate with a leadscrew stage: self-paced tracking";
  m.source = "McAfee 1994";
  m.order = 3;
  m.of_types<Options, Session>();
  m.keys = keys;
  m.described.by = "path.kind";
  m.validate = validate;
  m.texts.warnings = [](const lab::Settings& settings) {
    const auto& options = static_cast<const Options&>(settings);
    return options.tracks() ? table_of(options).warnings : std::vector<std::string>{};
  };
  m.traces.triggers = triggers;
  m.traces.vcd_bytes_s = 1.7e10;
  m.traces.fst_bytes_s = 4e8;
  m.columns = columns;
  m.figures = figures;
  m.verdict = lm628::verdict<Options, Result>;
  m.compared.companions = companions;
  m.compared.run_name = [](const lab::Settings& settings) {
    const auto& options = static_cast<const Options&>(settings);
    if (!options.tracks()) return std::string("motion");
    return options.speed == 0 ? std::string("self-paced") : name_of(options.speed);
  };
  m.files.metrics = add_metrics;
  m.files.detail = tracking_json;
  m.files.write = write_tables;
  m.files.drawn = [](const lab::Record& record) {
    const Result& result = result_of(record);
    return lab::Range{result.first, result.samples.size()};
  };
  m.page = page();
  return m;
}

}  // namespace

Table table_of(const Options& options) {
  try {
    return make_table(options.path, options.count_mm(), options.travel_mm());
  } catch (const cosim::OptionsError& error) {
    throw host::ConfigError(error.what());
  } catch (const std::invalid_argument& error) {  // the file of points
    throw host::ConfigError(fmt::format("path.points_file: {}", error.what()));
  }
}

const cosim::TriggerForms& triggers() {
  static const cosim::TriggerForms forms = cosim::stop_forms(signals(), lm628::kTriggerHelp);
  return forms;
}

const lab::Machine& machine() {
  static const lab::Machine description = describe();
  return description;
}

}  // namespace trammel::mcafee
