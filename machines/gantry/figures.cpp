// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine gantry is judged by.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "machines/gantry/host.hpp"
#include "machines/gantry/machine.hpp"

namespace trammel::gantry {
namespace {

// What the thesis shows of the experiment of a scenario: its figure, in words, and the overshoot
// where it prints one [% of the step], else below 0.
struct Published {
  const char* scenario;
  int figure;
  const char* says;
  double percent;
};
constexpr Published kPublished[] = {
    {"gantry-min-force", 35, "stops short of the reference", -1},
    {"gantry-p", 36, "overshoot of 0.26 %", 0.26},
    {"gantry-pi", 37, "overshoot of 45 %", 45},
    {"gantry-pi-cancel", 38, "overshoot of 4.5 %", 4.5},
    {"gantry-pi-aw", 39, "overshoot of 0.65 %", 0.65},
    {"gantry-pi-linear", 41, "a small overshoot, less with a larger TI", -1},
    {"gantry-friction", 47, "some oscillation, then smooth through the friction zones", -1},
    {"gantry-cascade-30", 52, "no overshoot", 0},
    {"gantry-cascade-k10", 53, "the small step overshoots", -1},
    {"gantry-cascade-k11", 54, "oscillates", -1},
    {"gantry-cascade", 55, "no overshoot, slower than P", 0},
    {"gantry-backlash", 59, "faster with compensation, no overshoot", 0}};

const Published* published(const std::string& scenario) {
  for (const Published& one : kPublished) {
    if (scenario == one.scenario) return &one;
  }
  return nullptr;
}

double mm(const Options& options, const Sample& s) { return 1e3 * s.x - options.zero_mm; }

}  // namespace

StepFigures step_figures(const Options& options, const Result& result) {
  StepFigures f;
  const auto sends = read_sends(options.sends);
  const double begin = sends.empty() ? 0 : sends.back().at_s;
  const double step = options.reference_mm - options.from_mm;
  double low = 1e9, high = -1e9, end = options.time_s;
  for (const Sample& s : result.samples) {
    const double t = cosim::seconds_of(s.edge, options.axis.clock_ps);
    if (t < begin) continue;
    const double off = mm(options, s) - options.reference_mm;
    f.overshoot_mm = std::max(f.overshoot_mm, step >= 0 ? off : -off);
    if (f.arrive_s < 0 && std::fabs(off) <= options.band_mm) f.arrive_s = t - begin;
    if (std::fabs(off) > 0.02 * std::fabs(step)) {
      f.settle_s = -1;
    } else if (f.settle_s < 0) {
      f.settle_s = t - begin;
    }
    f.rest_mm = off;
    if (t > end - 0.25 * (end - begin)) {
      low = std::min(low, off);
      high = std::max(high, off);
    }
  }
  f.swing_mm = std::max(0.0, high - low);
  return f;
}

std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  const auto& result = static_cast<const Result&>(run);
  const StepFigures f = step_figures(options, result);
  const double step = std::fabs(options.reference_mm - options.from_mm);
  double speed = 0, force = 0;
  for (const Sample& s : result.samples) {
    speed = std::max(speed, 1e3 * std::fabs(s.v));
    for (const int word : s.words.force) force = std::max(force, std::fabs(double(word)));
  }
  std::vector<lab::Figure> list;
  const auto add = [&list](lab::Figure one, const char* tile = "") {
    one.tile = tile;
    list.push_back(std::move(one));
  };
  using lab::count;
  using lab::figure;
  add(figure("step.overshoot_mm", "step", "overshoot", f.overshoot_mm, "mm", 3));
  lab::Figure percent = figure("step.overshoot_percent", "step", "overshoot of the step",
                               step > 0 ? 100 * f.overshoot_mm / step : 0, "%", 2);
  if (const Published* one = published(options.scenario); one != nullptr && one->percent >= 0) {
    percent.printed = one->percent;
    percent.source = fmt::format("Brochier 2006, figure {}", one->figure);
  }
  add(percent, "Overshoot");
  add(figure("step.arrive_s", "step", "until within the band", f.arrive_s, "s", 3), "Arrived");
  add(figure("step.settle_s", "step", "until within 2 % for good", f.settle_s, "s", 3), "Settled");
  add(figure("step.rest_mm", "step", "from the reference at the end", f.rest_mm, "mm", 3),
      "Rest");
  add(figure("step.swing_mm", "step", "peak to peak over the last quarter", f.swing_mm, "mm", 3));
  add(figure("max_speed_mm_s", "largest speed", "", speed, "mm/s", 1), "Largest speed");
  add(count("max_force", "largest force of either motor", "", force, "count"));
  add(count("passes", "control passes", "", result.passes));
  add(count("host.heard", "bytes", "from the chip", static_cast<double>(result.heard.size())));
  add(count("host.malformed", "frames", "malformed", result.malformed));
  add(count("host.lost", "frames", "lost", result.lost));
  add(count("host.unknown", "frames", "unknown", result.unknown));
  return list;
}

std::vector<std::string> remarks(const lab::Record& record) {
  const Result& result = result_of(record);
  std::vector<std::string> lines;
  if (const Published* one = published(options_of(record).scenario)) {
    lines.push_back(fmt::format("Brochier 2006, figure {}: {}", one->figure, one->says));
  }
  if (options_of(record).firmware.home) {
    lines.push_back(result.homed ? "homed" : "homing did not end");
  }
  if (result.fitted) lines.push_back("calibration fitted");
  std::string bytes;
  constexpr std::size_t kShown = 24;
  for (std::size_t k = 0; k < std::min(kShown, result.heard.size()); ++k) {
    bytes += fmt::format(" {:02X}", result.heard[k]);
  }
  if (!bytes.empty()) {
    lines.push_back("heard:" + bytes + (result.heard.size() > kShown ? " ..." : ""));
  }
  return lines;
}

void add_metrics(const lab::Record& record, nlohmann::ordered_json& json) {
  json["homed"] = result_of(record).homed;
  auto& source = json["published"] = nlohmann::ordered_json::object();
  if (const Published* one = published(options_of(record).scenario)) {
    source["figure"] = one->figure;
    source["says"] = one->says;
  }
  auto& words = json["calibration"] = nlohmann::ordered_json::array();
  for (const std::uint16_t word : result_of(record).store) words.push_back(word);
}

}  // namespace trammel::gantry
