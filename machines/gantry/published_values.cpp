// SPDX-License-Identifier: Apache-2.0
#include "machines/gantry/published_values.hpp"

#include <algorithm>
#include <memory>
#include <sstream>

#include <fmt/format.h>

#include "lab/layers.hpp"
#include "lab/scenarios.hpp"
#include "machines/gantry/machine_members.hpp"

namespace trammel::gantry {
namespace {

// A value that a figure of a run must have.
struct Judged {
  const char* id;
  double value, tolerance;
  bool printed = true;  // in words of the thesis; else read from its curve
};
constexpr const char* kOvershoot = "step.overshoot_percent";
constexpr Judged kArrives{"step.rest_mm", 0, 1, false};
constexpr Judged kWithinSecond{"step.arrive_s", 0.5, 0.5, false};

// A control count of 0.16 mm is 0.05 % of 305 mm. The thesis plots counts: three of them.
constexpr double kThreeCounts = 0.15;
constexpr Judged overshoots(double percent, double tolerance = kThreeCounts) {
  return {kOvershoot, percent, tolerance};
}
// At most a count of a step, whose size is in mm.
constexpr Judged no_overshoot(double step) { return {kOvershoot, 0, 100 * 5.0 / 32 / step}; }
// The basic PI depends on how long its sum has grown: specification, G-07 and G-16.
constexpr double kBasic = 8, kCancelled = 1;

struct Row {
  const char* scenario;
  const char* changed;  // settings besides
  int figure;
  const char* says;
  std::vector<Judged> judged;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      {"gantry-filter", "velocity.filter=low_pass_1", 21, "less noise, more than with order 2", {}},
      {"gantry-filter", "velocity.filter=low_pass_2", 21, "less noise than with order 1", {}},
      {"gantry-identify", "", 23, "3 samples of dead time, a fit of 53.49 % with order 3", {}},
      {"gantry-filter", "", 28, "noise as with order 2, smoother at reversals", {}},
      {"gantry-open", "", 30, "slower at 90 to 110 and 220 to 290 mm, peaks at 190 and 300 mm", {}},
      {"gantry-bang-bang", "position.max_force=256", 32, "oscillates", {}},
      {"gantry-bang-bang", "", 32, "oscillates", {}},
      {"gantry-bang-bang", "position.max_force=352", 32, "oscillates", {}},
      {"gantry-p", "position.gain=2 position.max_force=512", 34, "overshoot of 0.22 %",
       {overshoots(0.22), kArrives}},
      {"gantry-p", "position.gain=2 position.max_force=768", 34, "overshoot of 0.22 %",
       {overshoots(0.22), kArrives}},
      {"gantry-min-force", "", 35, "stops short of the reference", {}},
      {"gantry-min-force", "position.min_force=96", 35, "arrives", {kArrives}},
      {"gantry-min-force", "position.min_force=112", 35, "arrives", {kArrives}},
      {"gantry-min-force", "position.min_force=128", 35, "arrives", {kArrives}},
      {"gantry-min-force", "position.min_force=144", 35, "oscillates", {kArrives}},
      {"gantry-p", "position.gain=1", 36, "much too slow", {}},
      {"gantry-p", "position.gain=2", 36, "overshoot of 0.26 %", {overshoots(0.26), kArrives}},
      {"gantry-p", "", 36, "overshoot of 0.26 %", {overshoots(0.26), kArrives, kWithinSecond}},
      {"gantry-p", "position.gain=4", 36, "overshoot of 0.7 %", {overshoots(0.7), kArrives}},
      {"gantry-p", "position.gain=5", 36, "overshoot of 1.31 %", {overshoots(1.31), kArrives}},
      {"gantry-pi", "position.time_shift=8", 37, "overshoot of 71 %", {overshoots(71, kBasic)}},
      {"gantry-pi", "", 37, "overshoot of 45 %", {overshoots(45, kBasic)}},
      {"gantry-pi", "position.time_shift=10", 37, "overshoot of 26 %", {overshoots(26, kBasic)}},
      {"gantry-pi-cancel", "position.time_shift=5", 38, "overshoot of 4.5 %",
       {overshoots(4.5, kCancelled)}},
      {"gantry-pi-cancel", "", 38, "overshoot of 4.5 %", {overshoots(4.5, kCancelled)}},
      {"gantry-pi-cancel", "position.time_shift=10", 38, "overshoot of 4.5 %",
       {overshoots(4.5, kCancelled)}},
      {"gantry-pi-cancel", "position.time_shift=12", 38, "overshoot of 4.5 %",
       {overshoots(4.5, kCancelled)}},
      {"gantry-pi-cancel", "position.time_shift=16", 38, "like P", {kArrives}},
      {"gantry-pi-aw", "", 39, "overshoot of 0.65 %", {overshoots(0.65), kArrives}},
      {"gantry-pi-aw", "position.time_shift=10", 40, "a little faster than TI = 12", {kArrives}},
      {"gantry-pi-linear", "position.time_shift=5", 41, "some oscillation", {}},
      {"gantry-pi-linear", "", 41, "a small overshoot, less with a larger TI", {}},
      {"gantry-pi-linear", "position.time_shift=7", 41, "does not reach its reference for long",
       {}},
      {"gantry-velocity-p", "velocity.gain_shift=6", 43, "follows, disturbed by the friction zones",
       {}},
      {"gantry-velocity-p", "", 44, "follows better, disturbed at 250 mm", {}},
      {"gantry-velocity-p", "velocity.gain_shift=9", 45, "least disturbed, unstable when slow", {}},
      {"gantry-friction", "velocity.time_shift=13", 46, "some oscillation at the beginning", {}},
      {"gantry-friction", "", 47, "some oscillation, then smooth through the friction zones", {}},
      {"gantry-friction", "velocity.time_shift=15", 48, "an overshoot, no oscillation", {}},
      {"gantry-cascade-30", "control.cascade_gain=7", 50, "no overshoot",
       {no_overshoot(30), kArrives}},
      {"gantry-cascade-30", "control.cascade_gain=8", 51, "no overshoot",
       {no_overshoot(30), kArrives}},
      {"gantry-cascade-30", "", 52, "no overshoot", {no_overshoot(30), kArrives}},
      {"gantry-cascade-k10", "", 53, "the small step overshoots", {kArrives}},
      {"gantry-cascade-k11", "", 54, "oscillates", {}},
      {"gantry-cascade", "", 55, "no overshoot, slower than P", {no_overshoot(305), kArrives}},
      {"gantry-motor", "", 57, "slower to the left than motor 2, faster to the right", {}},
      {"gantry-motor", "control.motors=motor_2", 57, "more overshoot than motor 1 to the left", {}},
      {"gantry-backlash", "", 59, "faster with compensation, no overshoot",
       {no_overshoot(5), kArrives}},
      {"gantry-backlash", "control.compensate=false", 59, "slower than with compensation",
       {no_overshoot(5), kArrives}}};
  return all;
}

bool starts(const std::string& name, const char* with) { return name.rfind(with, 0) == 0; }

// Keys that change neither chip, program nor track.
bool is_beside(const std::string& name) {
  return name == "name" || name == "description" || starts(name, "run.") ||
         starts(name, "record.") || starts(name, "step.");
}
// Of these, the ones on which a figure depends.
bool is_of_figures(const std::string& name) {
  return name == "run.time_s" || starts(name, "step.");
}

struct Found {
  const Row* row = nullptr;
  bool alike = false;  // in what its figures depend on, too
};

Found row_of(const Options& options) {
  std::unique_ptr<lab::Settings> built_in;
  for (const Row& row : rows()) {
    if (options.scenario != row.scenario) continue;
    if (!built_in) built_in = lab::load_scenario(lab::find_scenario(row.scenario));
    const auto own = built_in->clone();
    std::istringstream changed(row.changed);
    for (std::string one; changed >> one;) lab::apply_assignment(*own, one);
    const auto same = [&](auto&& of_interest) {
      return std::all_of(keys().begin(), keys().end(), [&](const lab::Key& key) {
        return !of_interest(key.name) || key.get(options) == key.get(*own);
      });
    };
    if (same([](const std::string& name) { return !is_beside(name); })) {
      return {&row, same(is_of_figures)};
    }
  }
  return {};
}

}  // namespace

std::optional<ThesisFigure> thesis_figure(const Options& options) {
  const Row* const row = row_of(options).row;
  if (row == nullptr) return {};
  return ThesisFigure{row->figure, row->says};
}

void set_published_values(const Options& options, bool whole, std::vector<lab::Figure>& figures) {
  const Found found = row_of(options);
  if (found.row == nullptr) return;
  for (const Judged& one : found.row->judged) {
    for (lab::Figure& f : figures) {
      if (f.id != one.id) continue;
      if (one.printed) f.printed = one.value;
      if (found.alike && whole) {
        f.expected = one.value;
        f.tolerance = one.tolerance;
      }
      if (f.printed || f.expected) {
        f.source = fmt::format("Brochier 2006, figure {}", found.row->figure);
      }
    }
  }
}

}  // namespace trammel::gantry
