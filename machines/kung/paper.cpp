// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/paper.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "lab/scenarios.hpp"
#include "machines/kung/machine.hpp"

namespace trammel::kung {
namespace {

// Kung Table 2 (mean, "variance") and specification section 12 (mean, variance, std).
struct Tracking {
  PathKind path;
  Controller controller;
  double paper_mean, paper_spread;   // [mm], unit of the spread not clear in the paper
  double mean, variance, std;        // [mm], [mm2], [mm]
};

constexpr Tracking kTracking[] = {
    {PathKind::kCircle, Controller::kFc, 3.51, 0.60, 3.13, 0.40, 0.63},
    {PathKind::kWindow, Controller::kFc, 1.43, 2.12, 1.52, 1.60, 1.26},
    {PathKind::kStar, Controller::kFc, 1.64, 3.52, 1.74, 3.49, 1.87},
    {PathKind::kCircle, Controller::kAfc, 2.05, 0.40, 2.11, 0.44, 0.66},
    {PathKind::kWindow, Controller::kAfc, 1.22, 0.75, 1.13, 0.87, 0.93},
    {PathKind::kStar, Controller::kAfc, 1.43, 1.85, 1.38, 2.43, 1.56},
};

// Kung section 4, Figs. 11 and 12: overshoot of FC [%]; specification section 12: first and last of
// eight periods.
struct Step {
  Controller controller;
  std::optional<double> paper;
  double first, last;   // [%]
  double rms_first, rms_last;   // [mm], 0 = not given
};

const Step kStep[] = {
    {Controller::kFc, 12.8, 12.8, 12.8, 0, 0},
    {Controller::kFc, 23.1, 23.1, 22.8, 0, 0},
    {Controller::kAfc, {}, 12.7, 1.2, 1.15, 0.61},
    {Controller::kAfc, {}, 23.5, 4.0, 1.57, 0.72},
};

constexpr char kSource[] =
    "printed: Kung et al. 2012; expected: bit-exact model, specification section 12";
constexpr double kOvershootTolerance = 0.8;      // [points]
constexpr double kMeanTolerance = 0.03;          // relative
constexpr double kVarianceTolerance = 0.05;      // [mm2] and relative
constexpr double kPeakCurrentA = 1.4;            // step test with adaptation, either axis
constexpr double kCurrentTolerance = 0.05;       // [A]
// "Expected" figures are printed with two digits after the point: half a digit is theirs.
constexpr double kDigit = 0.005;

const char* builtin_name(PathKind kind) {
  switch (kind) {
    case PathKind::kCircle: return "circle";
    case PathKind::kWindow: return "window";
    case PathKind::kStar: return "star";
    case PathKind::kSquare: return "step";
    default: return "";
  }
}

}  // namespace

bool is_paper_experiment(const Options& options) {
  const std::string name = builtin_name(options.path.kind);
  if (name.empty()) return false;
  const auto reference = lab::load_scenario(lab::find_scenario(name));
  for (const lab::Key& key : keys()) {
    const bool free = key.name == "name" || key.name == "description" ||
                      key.name == "controller" || key.name == "plant.seed" ||
                      key.name.rfind("run.", 0) == 0;
    if (!free && key.get(options) != key.get(*reference)) return false;
  }
  return true;
}

void compare(const Options& options, std::vector<lab::Figure>& figures) {
  if (!is_paper_experiment(options)) return;
  const auto set = [&figures](const std::string& id, std::optional<double> printed,
                              std::optional<double> expected, double tolerance) {
    for (lab::Figure& f : figures) {
      if (f.id != id) continue;
      f.printed = printed;
      f.expected = expected;
      f.tolerance = tolerance;
      f.source = kSource;
    }
  };
  for (const Tracking& t : kTracking) {
    if (t.path != options.path.kind || t.controller != options.controller) continue;
    set("tracking.model.mean_mm", t.paper_mean, t.mean, kMeanTolerance * t.mean + kDigit);
    set("tracking.model.variance_mm2", t.paper_spread, t.variance,
        kVarianceTolerance * (1 + t.variance));
    set("tracking.model.std_mm", {}, t.std, kVarianceTolerance * (1 + t.variance) / (2 * t.std));
  }
  if (options.path.kind != PathKind::kSquare) return;
  const bool adapts = options.controller == Controller::kAfc;
  const auto last = fmt::format("periods.{}", options.path.square_periods - 1);
  for (std::size_t a = 0; a < 2; ++a) {
    const Step& step = kStep[(adapts ? 2 : 0) + a];
    const std::string axis = a == 0 ? "x." : "y.";
    set(axis + "periods.0.overshoot_percent", step.paper, step.first, kOvershootTolerance);
    set(axis + last + ".overshoot_percent", {}, step.last, kOvershootTolerance);
    if (step.rms_first <= 0) continue;
    set(axis + "periods.0.rms_mm", {}, step.rms_first, kMeanTolerance * step.rms_first + kDigit);
    set(axis + last + ".rms_mm", {}, step.rms_last, kMeanTolerance * step.rms_last + kDigit);
  }
  if (adapts) set("peak_current_A", {}, kPeakCurrentA, kCurrentTolerance + kDigit * 10);
}

}  // namespace trammel::kung
