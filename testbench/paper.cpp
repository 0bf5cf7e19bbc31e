// SPDX-License-Identifier: Apache-2.0
#include "testbench/paper.hpp"

#include <algorithm>
#include <cmath>

#include "testbench/config.hpp"

namespace trammel::testbench {
namespace {

using kung::Controller;
using kung::PathKind;

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
  const char* axis;
  std::optional<double> paper;
  double first, last;   // [%]
  double rms_first, rms_last;   // [mm], 0 = not given
};

const Step kStep[] = {
    {Controller::kFc, "X", 12.8, 12.8, 12.8, 0, 0},
    {Controller::kFc, "Y", 23.1, 23.1, 22.8, 0, 0},
    {Controller::kAfc, "X", {}, 12.7, 1.2, 1.15, 0.61},
    {Controller::kAfc, "Y", {}, 23.5, 4.0, 1.57, 0.72},
};

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

bool Comparison::good() const {
  return !expected || std::abs(ours - *expected) <= tolerance;
}

bool is_paper_experiment(const kung::Options& options) {
  const std::string name = builtin_name(options.path.kind);
  if (name.empty()) return false;
  kung::Options reference;
  apply_file(reference, find_scenario(name));
  for (const Key& key : keys()) {
    const bool free = key.name == "name" || key.name == "description" ||
                      key.name == "controller" || key.name == "plant.seed" ||
                      key.name.rfind("run.", 0) == 0;
    if (!free && key.get(options) != key.get(reference)) return false;
  }
  return true;
}

std::vector<Comparison> compare(const kung::Options& options, const Metrics& m) {
  std::vector<Comparison> lines;
  if (!m.complete || !is_paper_experiment(options)) return lines;
  for (const Tracking& t : kTracking) {
    if (t.path != options.path.kind || t.controller != options.controller) continue;
    lines.push_back({"mean", "mm", m.model_mm.mean, t.paper_mean, t.mean,
                     kMeanTolerance * t.mean + kDigit});
    lines.push_back({"variance", "mm2", m.model_mm.variance, t.paper_spread, t.variance,
                     kVarianceTolerance * (1 + t.variance)});
    lines.push_back({"standard deviation", "mm", m.model_mm.std, {}, t.std,
                     kVarianceTolerance * (1 + t.variance) / (2 * t.std)});
  }
  if (options.path.kind != PathKind::kSquare) return lines;
  double peak = 0;
  for (std::size_t a = 0; a < 2; ++a) {
    peak = std::max(peak, m.axis[a].peak_current_A);
    const auto& all = m.axis[a].periods;
    const Step& step = kStep[(options.controller == Controller::kFc ? 0 : 2) + a];
    if (all.empty()) continue;
    const std::string axis = step.axis;
    lines.push_back({"overshoot " + axis + ", first period", "%", all.front().overshoot_percent,
                     step.paper, step.first, kOvershootTolerance});
    lines.push_back({"overshoot " + axis + ", last period", "%", all.back().overshoot_percent, {},
                     step.last, kOvershootTolerance});
    if (step.rms_first > 0) {
      lines.push_back({"rms error " + axis + ", first period", "mm", all.front().rms_mm, {},
                       step.rms_first, kMeanTolerance * step.rms_first + kDigit});
      lines.push_back({"rms error " + axis + ", last period", "mm", all.back().rms_mm, {},
                       step.rms_last, kMeanTolerance * step.rms_last + kDigit});
    }
  }
  std::optional<double> expected;
  if (options.controller == Controller::kAfc) expected = kPeakCurrentA;
  lines.push_back({"peak current", "A", peak, {}, expected, kCurrentTolerance + kDigit * 10});
  return lines;
}

}  // namespace trammel::testbench
