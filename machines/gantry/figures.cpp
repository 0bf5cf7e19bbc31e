// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine gantry is judged by.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "machines/gantry/estimated.hpp"
#include "machines/gantry/host.hpp"
#include "machines/gantry/machine_members.hpp"
#include "machines/gantry/published_values.hpp"

namespace trammel::gantry {
namespace {

double mm(const Options& options, const Look& s) { return 1e3 * s.x - options.zero_mm; }

double settling_mm(const Options& options) {
  return 0.02 * std::fabs(options.reference_mm - options.from_mm);
}

}  // namespace

StepFigures step_figures(const Options& options, const Result& result) {
  StepFigures f;
  const auto sends = read_sends(options.sends);
  const double begin = sends.empty() ? 0 : sends.back().at_s;
  const double step = options.reference_mm - options.from_mm;
  double low = 1e9, high = -1e9, end = options.time_s;
  for (const Look& s : result.looks) {
    const double t = options.run.seconds(s.edge);
    if (t < begin) continue;
    const double off = mm(options, s) - options.reference_mm;
    f.overshoot_mm = std::max(f.overshoot_mm, step >= 0 ? off : -off);
    if (f.arrive_s < 0 && std::fabs(off) <= options.band_mm) f.arrive_s = t - begin;
    if (std::fabs(off) > settling_mm(options)) {
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
  f.begun =
      result.looks.empty() || options.run.seconds(result.looks.back().edge) >= begin;
  return f;
}

std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  const auto& result = static_cast<const Result&>(run);
  const StepFigures f = step_figures(options, result);
  const double step = std::fabs(options.reference_mm - options.from_mm);
  double speed = 0, force = 0;
  for (const Look& s : result.looks) {
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
  // Homing alone goes to a stop, and nothing asks for a step.
  if (f.begun && (options.serial || !read_sends(options.sends).empty())) {
    add(figure("step.overshoot_mm", "step", "overshoot", f.overshoot_mm, "mm", 3));
    add(figure("step.overshoot_percent", "step", "overshoot of the step",
               step > 0 ? 100 * f.overshoot_mm / step : 0, "%", 2),
        "Overshoot");
  }
  // A cart that never was there has no time.
  if (f.arrive_s >= 0) {
    add(figure("step.arrive_s", "step", fmt::format("until within {:g} mm", options.band_mm),
               f.arrive_s, "s", 3),
        "Arrived");
  }
  if (f.settle_s >= 0) {
    add(figure("step.settle_s", "step",
               fmt::format("until within {:g} mm (2 %) for good", settling_mm(options)), f.settle_s,
               "s", 3),
        "Settled");
  }
  if (f.begun) {
    add(figure("step.rest_mm", "step", "from the reference at the end", f.rest_mm, "mm", 3),
        "Rest");
    add(figure("step.swing_mm", "step", "peak to peak over the last quarter", f.swing_mm, "mm", 3));
  }
  if (options.firmware.open != sw::OpenForce::kNone) list = open_figures(options, result);
  add(figure("max_speed_mm_s", "largest speed", "", speed, "mm/s", 1), "Largest speed");
  add(count("max_force", "largest force of either motor", "", force, "count"));
  add(count("passes", "control passes", "", result.passes));
  add(count("host.heard", "bytes", "from the chip", static_cast<double>(result.heard.size())));
  add(count("host.malformed", "frames", "malformed", result.malformed));
  add(count("host.lost", "frames", "lost", result.lost));
  add(count("host.unknown", "frames", "unknown", result.unknown));
  add(count("host.unchecked", "frames", "without their checksum", result.unchecked));
  add(count("host.unsent", "frames", "of the chip without room", result.unsent));
  add(count("host.refused", "goals", "outside the track, refused", result.refused));
  set_published_values(options, result.end == cosim::EndReason::kDone, list);
  return list;
}

std::vector<std::string> remarks(const lab::Record& record) {
  const Result& result = result_of(record);
  std::vector<std::string> lines;
  const Options& options = options_of(record);
  if (const auto one = thesis_figure(options)) {
    lines.push_back(fmt::format("Brochier 2006, figure {}: {}", one->number, one->says));
  }
  const StepFigures step = step_figures(options, result);
  const bool steps = options.firmware.open == sw::OpenForce::kNone && !result.looks.empty();
  if (steps && !step.begun) {
    lines.push_back("the run ended before the last of host.sends: the step has no figures");
  } else if (steps && step.arrive_s < 0) {
    lines.push_back(fmt::format("the cart was never within {:g} mm of {:g} mm (step.band_mm)",
                                options.band_mm, options.reference_mm));
  } else if (steps && step.settle_s < 0) {
    lines.push_back(fmt::format("the cart is not within {:g} mm (2 %) of {:g} mm at the end",
                                settling_mm(options), options.reference_mm));
  }
  if (options.firmware.home) {
    lines.push_back(result.homed ? "homed" : "homing did not end");
  }
  if (result.fitted) lines.push_back("calibration fitted");
  if (options.firmware.open == sw::OpenForce::kRandom) {
    for (std::string& line : open_remarks(result)) lines.push_back(std::move(line));
  }
  std::string bytes;
  constexpr std::size_t kShown = 24;
  for (std::size_t k = 0; k < std::min(kShown, result.heard.size()); ++k) {
    bytes += fmt::format(" {:02X}", result.heard[k]);
  }
  if (!bytes.empty()) {
    const std::size_t all = result.heard.size();
    if (all > kShown) bytes += fmt::format(" ...; all {} bytes: metrics.json, heard", all);
    lines.push_back("heard:" + bytes);
  }
  return lines;
}

void add_metrics(const lab::Record& record, nlohmann::ordered_json& json) {
  json["homed"] = result_of(record).homed;
  json["identified"] = identified_json(result_of(record));
  std::string heard;
  for (const unsigned char byte : result_of(record).heard) heard += fmt::format("{:02X}", byte);
  json["heard"] = heard;
  auto& source = json["published"] = nlohmann::ordered_json::object();
  if (const auto one = thesis_figure(options_of(record))) {
    source["figure"] = one->number;
    source["says"] = one->says;
  }
  auto& words = json["calibration"] = nlohmann::ordered_json::array();
  for (const std::uint16_t word : result_of(record).store) words.push_back(word);
}

}  // namespace trammel::gantry
