// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/judge/figures.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "machines/kung/chip/measures.hpp"
#include "machines/kung/judge/baseline.hpp"
#include "machines/kung/judge/comparison.hpp"
#include "machines/kung/judge/motor_load.hpp"
#include "machines/kung/judge/paper.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/precision/figures.hpp"
#include "machines/kung/run/cpu.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/outcome.hpp"
#include "machines/kung/run/response.hpp"

namespace trammel::kung {
namespace {

using lab::Figure;
using List = std::vector<Figure>;

constexpr std::size_t kLapsShown = 8;  // and the last one

// What the figures of an axis are made of.
struct AxisSignals {
  Series position_m, model_m, error_mm;
  double peak_current_A = 0, max_speed_m_s = 0;
};

void add_spread(List& list, const std::string& id, const std::string& row, const Series& series) {
  const Spread s = spread(series);
  const auto add = [&](const char* name, const char* column, double value, const char* unit) {
    list.push_back(lab::figure(id + name, row, column, value, unit));
    list.back().shown = s.n > 0;
  };
  add(".mean_mm", "mean", s.mean, "mm");
  add(".std_mm", "std", s.std, "mm");
  add(".variance_mm2", "var", s.variance, "mm2");
  add(".rms_mm", "rms", s.rms, "mm");
  add(".max_mm", "max", s.max, "mm");
  list.push_back(lab::count(id + ".samples", row, "samples", static_cast<double>(s.n)));
  list.back().shown = false;
}

void add_periods(List& list, const std::string& id, const std::string& of,
                 const std::vector<HalfPeriod>& all, bool shown) {
  const auto add = [&](const char* name, const char* what, double HalfPeriod::* member,
                       const char* unit, int digits) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      list.push_back(lab::figure(fmt::format("{}.{}.{}", id, k, name),
                                 fmt::format("{} {}", what, of), fmt::format("{}", k + 1),
                                 all[k].*member, unit, digits));
      list.back().shown = shown;
    }
  };
  add("overshoot_percent", "overshoot", &HalfPeriod::overshoot_percent, "%", 1);
  add("rms_mm", "rms error", &HalfPeriod::rms_mm, "mm", 2);
}

// Of a path that was passed several times; the last lap has the last point's samples too.
void add_laps(List& list, const Options& options, const Result& result, const Series& to_model_mm,
              const Series& contour_mm) {
  const auto laps = static_cast<std::size_t>(options.path.repeats);
  if (laps < 2 || options.path.kind == PathKind::kSquare || result.points < 2) return;
  const auto held = static_cast<std::size_t>(ticks_per_point(options));
  const std::size_t samples = (result.points - 1) / laps * held;
  if (!result.whole() || laps * samples > to_model_mm.size()) return;
  for (std::size_t lap = 0; lap < laps; ++lap) {
    Series of_model, of_contour;
    const std::size_t end = lap + 1 == laps ? to_model_mm.size() : (lap + 1) * samples;
    for (std::size_t k = lap * samples; k < end; ++k) {
      of_model.push_back(to_model_mm[k]);
      of_contour.push_back(contour_mm[k]);
    }
    add_tracking(list, fmt::format("laps.{}", lap), fmt::format("lap {}", lap + 1), of_model,
                 of_contour);
    for (std::size_t n = list.size() - 3; n < list.size(); ++n) {
      list[n].shown = lap < kLapsShown || lap + 1 == laps;
    }
    if (feeds(options)) list.pop_back();  // a contour against rounded points
  }
}

void set_tiles(List& list, std::size_t periods) {
  const auto set = [&list](const std::string& id, const char* name) {
    for (Figure& f : list) {
      if (f.id == id) f.tile = name;
    }
  };
  set("tracking.model.mean_mm", "Mean tracking error");
  set("tracking.model.std_mm", "Standard deviation");
  set("tracking.model.max_mm", "Largest error");
  set("contour.mean_mm", "Mean contour error");
  set("contour_um.mean", "Mean contour error");
  set("peak_current_A", "Peak current");
  set("error_um.mean", "Mean error to the command");
  set("error_um.max", "Largest of it");
  if (periods == 0) {
    set("max_speed_m_s", "Top speed");
  } else {
    set(fmt::format("x.periods.{}.overshoot_percent", periods - 1), "Overshoot X");
    set(fmt::format("y.periods.{}.overshoot_percent", periods - 1), "Overshoot Y");
  }
}

// From the last point's sample on; not shown where the table is still outside at the end.
void add_settling(List& list, const Options& options, const Result& result, const Range& range) {
  Points after;
  PointM last;
  for (std::size_t k = range.last; k < result.samples.size(); ++k) {
    const Sample sample = result.samples[k];
    const double count_m = options.plant.axis[0].encoder_count_m;
    last = {command_m(sample.axis[0], count_m), command_m(sample.axis[1], count_m)};
    after.push_back({sample.axis[0].x_true_m, sample.axis[1].x_true_m});
  }
  const std::size_t samples = settled_after(after, last, options.settled_m);
  list.push_back(lab::figure("at_end.settling_s", "at the end", "settling",
                             static_cast<double>(samples) * options.chip.sample_s(), "s", 3));
  list.back().shown = result.whole() && samples < after.size();
}

}  // namespace

List figures(const lab::Settings& settings, cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  auto& result = static_cast<Result&>(run);
  const Range range = counted(result);
  result.load = {};
  Points table, command;
  Series to_model_mm, to_command_mm, contour_mm;
  double left_mm = 0, right_mm = 0;
  std::array<AxisSignals, 2> axes;
  for (std::size_t k = range.first; k < range.last; ++k) {
    const Sample sample = result.samples[k];
    double asked_m[2];
    for (std::size_t a = 0; a < 2; ++a) {
      const AxisSample& at = sample.axis[a];
      const double count_m = options.plant.axis[a].encoder_count_m;
      AxisSignals& axis = axes[a];
      asked_m[a] = command_m(at, count_m);
      axis.position_m.push_back(at.x_true_m);
      axis.model_m.push_back(model_m(at, count_m));
      axis.error_mm.push_back((axis.model_m.back() - at.x_true_m) * kMm);
      axis.peak_current_A = std::max(axis.peak_current_A, std::abs(at.i_q_true_A));
      axis.max_speed_m_s = std::max(axis.max_speed_m_s, std::abs(at.v_true_m_s));
      result.load[a].add(at, options.plant.axis[a]);
    }
    table.push_back({axes[0].position_m.back(), axes[1].position_m.back()});
    command.push_back({asked_m[0], asked_m[1]});
    const PointM model{axes[0].model_m.back(), axes[1].model_m.back()};
    to_model_mm.push_back(tracking_error(model, table.back()) * kMm);
    to_command_mm.push_back(tracking_error(command.back(), table.back()) * kMm);
  }
  const auto& path = options.path;
  const bool square = path.kind == PathKind::kSquare;
  if (!square && !path.is_sweep()) {
    const std::size_t reach = contour_reach(options.lag_s(), options.chip.sample_s());
    for (const double error : signed_contour_error(table, command, reach)) {
      contour_mm.push_back(std::abs(error) * kMm);
      left_mm = std::max(left_mm, error * kMm);
      right_mm = std::max(right_mm, -error * kMm);
    }
  }

  const Series& judged = square ? to_model_mm : contour_mm;
  result.largest_mm = judged.empty() ? 0 : spread(judged).max;

  List list;
  add_spread(list, "tracking.model", "T(k) to reference model", to_model_mm);
  // Under the feed profile the path itself is known: add_command_figures() has both against it, not
  // against points that are rounded to the encoder's counts.
  const bool by_points = !feeds(options);
  if (by_points) add_spread(list, "tracking.command", "T(k) to command", to_command_mm);
  if (by_points && !contour_mm.empty()) {
    add_spread(list, "contour", "contour", contour_mm);
    list.push_back(lab::figure("contour.left_mm", "contour by side", "left", left_mm, "mm", 3));
    list.push_back(
        lab::figure("contour.right_mm", "contour by side", "right", right_mm, "mm", 3));
  }
  add_spread(list, "x.error_to_model", "X to reference model", axes[0].error_mm);
  add_spread(list, "y.error_to_model", "Y to reference model", axes[1].error_mm);
  if (options.controller == Controller::kPrecision) {  // its own figures are finer, and in um
    for (Figure& f : list) f.shown = false;
  }
  if (!by_points) add_command_figures(list, *plan_of(options), result);
  if (!path.is_sweep()) add_laps(list, options, result, to_model_mm, contour_mm);
  for (Figure& f : list) f.shown = f.shown && !path.open_position();  // nothing to track
  const auto add_peak = [&](const std::string& id, const char* row, double AxisSignals::* member,
                            const char* unit, int digits) {
    const double x = axes[0].*member;
    const double y = axes[1].*member;
    list.push_back(lab::figure(id, row, "", std::max(x, y), unit, digits));
    list.push_back(lab::figure("x." + id, row, "X", x, unit, digits));
    list.push_back(lab::figure("y." + id, row, "Y", y, unit, digits));
    for (std::size_t n = list.size() - 3; n < list.size(); ++n) {
      list[n].shown = range.last > range.first;
    }
  };
  list.push_back(lab::figure("at_end.from_last_point_mm", "at the end", "from the last point",
                             result.from_last_m * kMm, "mm", 2));
  list.back().shown = !path.is_sweep() &&
                      (result.end == EndReason::kDone || result.end == EndReason::kMissed);
  list.push_back(lab::figure("at_end.stopping_mm", "after the trip", "way to rest",
                             result.fault_report.stopping, "mm", 2));
  list.back().shown = result.end == EndReason::kFault && result.points > 0 &&
                      result.fault_report.off != cosim::kNever;
  if (options.settle_s > 0) add_settling(list, options, result, range);
  add_peak("peak_current_A", "peak i_q of the samples", &AxisSignals::peak_current_A, "A", 2);
  add_peak("max_speed_m_s", "top speed", &AxisSignals::max_speed_m_s, "m/s", 3);
  add_motor_load(list, options, result);
  if (path.is_sweep()) add_responses(list, *plan_of(options), result);
  std::vector<HalfPeriod> halves[2];
  for (std::size_t a = 0; a < 2 && square; ++a) {
    halves[a] = half_periods(axes[a].position_m, axes[a].model_m,
                             static_cast<std::size_t>(square_half_samples(options)),
                             path.square_low_m,
                             path.square_high_m);
  }
  add_periods(list, "x.half_periods", "X, half period", halves[0], false);
  add_periods(list, "y.half_periods", "Y, half period", halves[1], false);
  add_periods(list, "x.periods", "X, period", periods(halves[0]), true);
  add_periods(list, "y.periods", "Y, period", periods(halves[1]), true);
  if (!path.is_sweep()) set_tiles(list, halves[0].size() / 2);
  if (result.end == EndReason::kDone) {
    if (!path.is_sweep()) add_baselines(options, list);
    compare(options, list);
  }
  return list;
}

namespace {

// The identification move itself goes so far, which no start value makes less.
std::string swing_text(const Options& options, const Result& result) {
  constexpr double kWay_m = 0.8e-3;
  const bool by_key = options.diverged_m < kFarthestSwing_m;
  return fmt::format("diverged: {:.2f} mm from the start in the identification move of 0.8 mm{}{}",
                     result.swing_m * kMm,
                     by_key ? fmt::format(", above run.diverged_m = {:g}", options.diverged_m) : "",
                     options.diverged_m < kWay_m
                         ? "; allowed with the precision controller: above 0.0008"
                         : "; precision.mass_kg, viscous_N_s_m or coulomb_N is too far from the "
                           "plant's, or an encoder or a drive has failed");
}

}  // namespace

std::string verdict(const lab::Settings& settings, const cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  const auto& result = static_cast<const Result&>(run);
  std::string limits;  // of the drives that had no more to give
  for (std::size_t a = 0; a < 2; ++a) {
    const std::string of = result.load[a].limits();
    if (!of.empty()) limits += fmt::format("; {}: {}", a == 0 ? 'X' : 'Y', of);
  }
  switch (result.end) {
    case EndReason::kDone:
      if (options.path.is_sweep()) return sweep_text(*plan_of(options), result);
      if (options.controller == Controller::kPrecision) {
        return fmt::format("followed {} point{}, at most {} from the command, {} from the last one",
                           result.points, result.points == 1 ? "" : "s",
                           length_text(result.error_m), length_text(result.from_last_m));
      }
      return fmt::format("followed {} point{}, at most {:.2f} mm {}, {:.2f} mm from the last one",
                         result.points, result.points == 1 ? "" : "s", result.largest_mm,
                         options.path.kind == PathKind::kSquare ? "from the model" : "beside them",
                         result.from_last_m * kMm);
    case EndReason::kFault:
      if (result.fault.code == FaultCode::kNone) {
        return fmt::format("tripped: {}", cause_text(result.fault));
      }
      return fmt::format("tripped: {} at position tick {} ({:.4f} s)", cause_text(result.fault),
                         result.fault.tick, result.fault.tick * options.chip.sample_s());
    case EndReason::kDiverged:
      if (result.swing_m > 0) return swing_text(options, result) + limits;
      if (result.beside_m > 0) {
        return fmt::format("diverged: {:.4f} m beside the path asked, above run.diverged_m = "
                           "{:g}{}", result.beside_m, options.diverged_m, limits);
      }
      return fmt::format("diverged: error to the model above run.diverged_m = {:g}{}",
                         options.diverged_m, limits);
    case EndReason::kMissed: return "missed: " + result.missed + limits;
    case EndReason::kStopped: return "interrupted: results up to that point";
    default: return lab::verdict_text(options, result);
  }
}

std::vector<std::string> remarks(const lab::Record& record) {
  const Options& options = options_of(record);
  const Result& result = result_of(record);
  std::vector<std::string> lines = overloads(options, result);
  for (std::string& line : range_lines(options, result)) lines.push_back(std::move(line));
  for (std::string& line : comparison_lines(record)) lines.push_back(std::move(line));
  if (options.path.kind == PathKind::kCircle && options.controller != Controller::kPrecision) {
    if (const auto reading = paper_experiment(options)) lines.push_back(circle_note(*reading));
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
  for (std::string& line : cpu_lines(options, result)) lines.push_back(std::move(line));
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
  add_cpu(options_of(record), result, json);
  if (options_of(record).controller == Controller::kPrecision) {
    add_precision(options_of(record), json);
  }
  const bool compared = std::any_of(record.figures.begin(), record.figures.end(),
                                    [](const Figure& f) { return f.printed.has_value(); });
  const auto reading = paper_experiment(options_of(record));
  if (compared && reading && options_of(record).path.kind == PathKind::kCircle) {
    json["comparison_note"] = circle_note(*reading);
  }
}

}  // namespace trammel::kung
