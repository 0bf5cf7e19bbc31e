// SPDX-License-Identifier: Apache-2.0
//
// The figures of a run as the laboratory's list, and what is said of its end.
#include <fmt/format.h>

#include <algorithm>

#include "machines/kung/figures.hpp"
#include "machines/kung/machine.hpp"
#include "machines/kung/paper.hpp"

namespace trammel::kung {
namespace {

using lab::Figure;
using List = std::vector<Figure>;

void add_spread(List& list, const std::string& id, const std::string& row, const Spread& s,
                bool shown) {
  const std::size_t first = list.size();
  list.push_back(lab::figure(id + ".mean_mm", row, "mean", s.mean, "mm"));
  list.push_back(lab::figure(id + ".std_mm", row, "std", s.std, "mm"));
  list.push_back(lab::figure(id + ".variance_mm2", row, "var", s.variance, "mm2"));
  list.push_back(lab::figure(id + ".rms_mm", row, "rms", s.rms, "mm"));
  list.push_back(lab::figure(id + ".max_mm", row, "max", s.max, "mm"));
  for (std::size_t n = first; n < list.size(); ++n) list[n].shown = shown;
  list.push_back(lab::count(id + ".samples", row, "samples", static_cast<double>(s.n)));
  list.back().shown = false;
}

void add_halves(List& list, const std::string& id, const std::string& of, char axis,
                const std::vector<HalfPeriod>& halves, bool shown) {
  const auto add = [&](const char* name, const char* what, double HalfPeriod::* member,
                       const char* unit, int digits) {
    for (std::size_t k = 0; k < halves.size(); ++k) {
      list.push_back(lab::figure(fmt::format("{}.{}.{}", id, k, name),
                                 fmt::format("{} {}, {}", what, axis, of), fmt::format("{}", k + 1),
                                 halves[k].*member, unit, digits));
      list.back().shown = shown;
    }
  };
  add("overshoot_percent", "overshoot", &HalfPeriod::overshoot_percent, "%", 1);
  add("rms_mm", "rms error", &HalfPeriod::rms_mm, "mm", 2);
}

void set_tile(List& list, const std::string& id, const char* name) {
  for (Figure& f : list) {
    if (f.id == id) f.tile = name;
  }
}

const char* cause_name(FaultCode code);

}  // namespace

List figures(const lab::Settings& settings, cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  const Metrics m = evaluate(options, static_cast<const Result&>(run));
  const bool shown = m.samples > 0;
  List list;
  add_spread(list, "tracking.model", "T(k) to reference model", m.model_mm, shown);
  add_spread(list, "tracking.command", "T(k) to command", m.command_mm, shown);
  if (m.contour_mm.n > 0) add_spread(list, "contour", "contour", m.contour_mm, shown);
  add_spread(list, "x.error_to_model", "X to reference model", m.axis[0].model_mm, shown);
  add_spread(list, "y.error_to_model", "Y to reference model", m.axis[1].model_mm, shown);
  const auto add_both = [&](const char* name, const char* row, double AxisMetrics::* member,
                            const char* unit, int digits) {
    const double x = m.axis[0].*member;
    const double y = m.axis[1].*member;
    list.push_back(lab::figure(name, row, "", std::max(x, y), unit, digits));
    list.push_back(lab::figure(std::string("x.") + name, row, "X", x, unit, digits));
    list.push_back(lab::figure(std::string("y.") + name, row, "Y", y, unit, digits));
    for (std::size_t n = list.size() - 3; n < list.size(); ++n) list[n].shown = shown;
  };
  add_both("peak_current_A", "peak current", &AxisMetrics::peak_current_A, "A", 2);
  add_both("max_speed_m_s", "top speed", &AxisMetrics::max_speed_m_s, "m/s", 3);
  for (std::size_t a = 0; a < 2; ++a) {
    const std::string axis = a == 0 ? "x." : "y.";
    add_halves(list, axis + "half_periods", "half period", a == 0 ? 'X' : 'Y', m.axis[a].halves,
               false);
  }
  for (std::size_t a = 0; a < 2; ++a) {
    const std::string axis = a == 0 ? "x." : "y.";
    add_halves(list, axis + "periods", "period", a == 0 ? 'X' : 'Y', m.axis[a].periods, true);
  }
  set_tile(list, "tracking.model.mean_mm", "Mean tracking error");
  set_tile(list, "tracking.model.std_mm", "Standard deviation");
  set_tile(list, "tracking.model.max_mm", "Largest error");
  set_tile(list, "contour.mean_mm", "Mean contour error");
  if (!m.axis[0].periods.empty()) {
    const std::size_t last = m.axis[0].periods.size() - 1;
    set_tile(list, fmt::format("x.periods.{}.overshoot_percent", last), "Overshoot X");
    set_tile(list, fmt::format("y.periods.{}.overshoot_percent", last), "Overshoot Y");
  }
  set_tile(list, "peak_current_A", "Peak current");
  if (m.axis[0].periods.empty()) set_tile(list, "max_speed_m_s", "Top speed");
  if (m.complete) compare(options, list);
  return list;
}

std::string verdict(const lab::Settings& settings, const cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  const auto& result = static_cast<const Result&>(run);
  switch (result.end) {
    case EndReason::kDone: return fmt::format("followed {} points", result.points);
    case EndReason::kFault:
      if (result.fault.code == FaultCode::kNone) {
        return fmt::format("TRIPPED: {}", cause_text(result.fault));
      }
      return fmt::format("TRIPPED: {} at 2 kHz tick {} ({:.4f} s)", cause_text(result.fault),
                         result.fault.tick, result.fault.tick * 0.5e-3);
    case EndReason::kDiverged:
      return fmt::format("DIVERGED: error to the model above run.diverged_m = {:g}",
                         options.diverged_m);
    case EndReason::kTimeout:
      return fmt::format("NOT FINISHED within run.max_s = {:g}", options.run.max_s);
    case EndReason::kStopped: return "INTERRUPTED: results up to there";
    case EndReason::kPromise:
      return "ASSERTION FAILED: " + lab::promise_text(*result.promise);
  }
  return "";
}

std::vector<std::string> remarks(const lab::Record& record) {
  const Options& options = options_of(record);
  const Result& result = result_of(record);
  std::vector<std::string> lines;
  if (options.path.kind == PathKind::kCircle && is_paper_experiment(options)) {
    lines.emplace_back(kCircleNote);
  }
  const auto evaluated = static_cast<double>(std::max<cosim::Clk>(1, result.evaluated));
  std::string causes;
  for (std::size_t n = 0; n < kWakes; ++n) {
    const double share = 100 * static_cast<double>(result.wakes[n]) / evaluated;
    if (share < 0.05) continue;
    std::string name = kWakeNames[n];
    std::replace(name.begin(), name.end(), '_', ' ');
    causes += fmt::format("{}{} {:.1f} %", causes.empty() ? "" : ", ", name, share);
  }
  if (!causes.empty()) lines.push_back("clocks evaluated for: " + causes);
  return lines;
}

void add_metrics(const lab::Record& record, nlohmann::ordered_json& json) {
  const Result& result = result_of(record);
  if (result.fault.code != FaultCode::kNone) {
    json["fault"] = {{"cause", cause_name(result.fault.code)},
                     {"axis", result.fault.axis == 0 ? "x" : "y"},
                     {"processor", result.fault.processor},
                     {"tick", result.fault.tick}};
  }
  nlohmann::ordered_json& run = json["run"];
  run["points"] = result.points;
  run["first_tick"] = result.first_tick;
  run["end_tick"] = result.end_tick;
  for (std::size_t n = 0; n < kWakes; ++n) run["wakes"][kWakeNames[n]] = result.wakes[n];
  const Options& options = options_of(record);
  const bool compared = std::any_of(record.figures.begin(), record.figures.end(),
                                    [](const Figure& f) { return f.printed.has_value(); });
  if (compared && options.path.kind == PathKind::kCircle) json["comparison_note"] = kCircleNote;
}

namespace {

const char* cause_name(FaultCode code) {
  switch (code) {
    case FaultCode::kNone: return "none";
    case FaultCode::kTrip: return "external trip";
    case FaultCode::kOverCurrent: return "over-current";
    case FaultCode::kWatchdog: return "watchdog";
    case FaultCode::kEncoder: return "encoder fault";
    case FaultCode::kStroke: return "stroke exceeded";
  }
  return "unknown";
}

}  // namespace

std::string cause_text(const Fault& fault) {
  if (fault.code == FaultCode::kNone) return "the processor's check: " + fault.processor;
  if (fault.code == FaultCode::kTrip || fault.code == FaultCode::kWatchdog) {
    return cause_name(fault.code);  // of no axis
  }
  return fmt::format("{} on axis {}", cause_name(fault.code), fault.axis == 0 ? 'X' : 'Y');
}

std::string Result::fault_text() const {
  if (end != cosim::EndReason::kFault) return {};
  return cause_text(fault);
}

}  // namespace trammel::kung
