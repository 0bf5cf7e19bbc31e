// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine an693 is judged by, and the columns of its trace.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include "machines/an693/machine_members.hpp"
#include "parts/lm628/columns.hpp"
#include "parts/lm628/rest.hpp"

namespace trammel::an693 {
namespace {

// Samples are counted from the first in which the desired position moves, that being 1.
struct Motion {
  std::int64_t samples = 0;    // until the desired position stood for good
  double overshoot_counts = 0; // beyond the desired position, in the direction of motion
  double settled_s = 0;        // from the first motion until within the band, for good or until
                               // the next
};

// Also puts the interrupts into the result.
Motion motion_of(const Options& options, Result& result) {
  constexpr double kSettledBand = 2.5;  // [count]
  Motion m;
  std::int64_t sample = 0, before = 0;
  int direction = 0;
  bool irq = false, first = true;
  result.interrupts.clear();
  for (const Sample& s : result.samples) {
    const lm628::Words& w = s.words;
    // With the motor off, the desired position follows the real one.
    const bool off = (w.status & sw::lm628_status::kMotorOff) != 0;
    const bool moves = !off && w.position != before;
    if (sample > 0 || moves) ++sample;
    if (moves) {
      first = first && (m.samples == 0 || sample == m.samples + 1);
      m.samples = sample;
      direction = w.position > before ? 1 : -1;
    }
    before = w.position;
    const double desired = static_cast<double>(w.position) / lm628::kPerCount;
    const double beyond = (shaft_counts(options, s.theta) - desired) * direction;
    // A step moves the desired position within one sample: what counts is where the shaft goes.
    if (sample > 0 && !off) m.overshoot_counts = std::max(m.overshoot_counts, beyond);
    if (first && std::fabs(beyond) > kSettledBand) {
      m.settled_s = static_cast<double>(sample) * options.sample_s();
    }
    if (s.host_irq && !irq) {
      result.interrupts.push_back(
          {sample, result.seconds(s.edge), w.position >> 16, w.actual, w.status});
    }
    irq = s.host_irq;
  }
  return m;
}

}  // namespace

double shaft_counts(const Options& options, double theta) {
  return theta / plant::MotorAxis::kTurn * options.plant.counts;
}

std::string what_missed(const Options& options, const Result& result) {
  const auto& all = result.samples;
  if (all.empty()) return "";
  const auto desired = [&all](std::size_t k) { return all[k].words.position >> 16; };
  std::int64_t travel = 0;
  for (std::size_t k = 0; k < all.size(); ++k) travel = std::max(travel, std::abs(desired(k)));
  using Program = sw::An693Program;
  const bool held = options.program == Program::kHold;
  const bool steps = options.program == Program::kTuning;
  const bool goes = options.program != Program::kBreakpoints && !held;
  const double band =
      lm628::reached_band(options.reached_counts, held ? 200 : static_cast<double>(travel));

  // A move of samples `begin` to `end`, which was to end at `asked`.
  const auto missed = [&](std::size_t begin, std::size_t end, std::int64_t asked) -> std::string {
    const std::int64_t target = desired(end - 1);
    if (goes && target != asked) {
      return fmt::format("the trajectory ended at {} counts, not at {}", target, asked);
    }
    std::size_t stood = 1;  // samples at the end
    while (stood < end - begin && desired(end - 1 - stood) == target) ++stood;
    const lm628::Rest rest = lm628::rest_of(
        end - std::max<std::size_t>(1, stood / 2), end - 1, static_cast<double>(target),
        [&](std::size_t k) { return shaft_counts(options, all[k].theta); });
    if (rest.moves > band) {
      return fmt::format("the shaft moves by {:.0f} counts at the end", rest.moves);
    }
    // A held shaft gives way to the torque.
    if (held || std::abs(rest.off) <= band) return "";
    return fmt::format("the shaft is {:.0f} counts from the target of {}", std::abs(rest.off),
                       target);
  };
  if (!steps) return missed(0, all.size(), options.position);
  std::size_t begin = 0;
  for (std::size_t n = 0; n < result.step_ends.size(); ++n) {  // there, and back
    const std::size_t end = result.step_ends[n];
    const std::string what = end > begin ? missed(begin, end, n % 2 == 0 ? options.position : 0)
                                         : "no sample fell in it";
    if (!what.empty()) {
      return fmt::format("step {} of {}: {}", n + 1, result.step_ends.size(), what);
    }
    begin = end;
  }
  return "";
}

std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  auto& result = static_cast<Result&>(run);
  const Motion m = motion_of(options, result);
  const bool done = result.end == cosim::EndReason::kDone;
  const auto largest = [&](auto get) {
    double most = 0;
    for (const Sample& s : result.samples) {
      most = std::max(most, std::fabs(static_cast<double>(std::invoke(get, s))));
    }
    return most;
  };
  std::vector<lab::Figure> list;
  const auto add = [&list](lab::Figure f, const char* tile = "", bool shown = true) {
    f.tile = tile;
    f.shown = shown;
    list.push_back(std::move(f));
  };
  using lab::count;
  using lab::figure;
  const auto samples = static_cast<double>(m.samples);
  add(count("motion.samples", "motion", "", samples, "samples"));
  add(figure("motion.time_s", "motion", "", samples * options.sample_s(), "s", 4), "Motion");
  add(count("motion.desired_count", "end position", "desired", result.desired, "counts"), "", done);
  add(count("motion.real_count", "end position", "real", result.real, "counts"), "Real position",
      done);
  add(figure("motion.overshoot_counts", "overshoot", "", m.overshoot_counts, "counts", 2),
      "Overshoot");
  add(figure("motion.settled_s", "first step settled", "", m.settled_s, "s", 4), "",
      options.program == sw::An693Program::kTuning);
  add(count("motion.max_error_counts", "largest error", "",
            largest([](const Sample& s) { return s.words.error; }), "counts"),
      "Largest error");
  add(figure("motion.max_speed_rev_s", "largest speed", "",
             largest(&Sample::omega) / plant::MotorAxis::kTurn, "rev/s"), "Top speed");
  add(figure("motion.max_voltage_V", "largest voltage", "", largest(&Sample::volt), "V", 2));
  add(figure("motion.max_current_A", "largest current", "", largest(&Sample::i), "A"),
      "Peak current");
  add(count("motion.interrupts", "host interrupts", "",
            static_cast<double>(result.interrupts.size())));
  return list;
}

void add_metrics(const lab::Record& record, nlohmann::ordered_json& json) {
  auto& all = json["interrupts"] = nlohmann::ordered_json::array();
  for (const auto& one : result_of(record).interrupts) {
    all.push_back({{"sample", one.sample}, {"time_s", one.time_s}, {"desired_count", one.desired},
                   {"real_count", one.real}, {"status", one.status}});
  }
}

std::vector<std::string> remarks(const lab::Record& record) {
  constexpr std::size_t kMost = 10;
  const auto& interrupts = result_of(record).interrupts;
  std::vector<std::string> lines;
  for (const auto& one : interrupts) {
    if (lines.size() == kMost) {
      lines.push_back(fmt::format("and {} more host interrupts", interrupts.size() - kMost));
      break;
    }
    lines.push_back(fmt::format(
        "host interrupt at {:.4f} s, {}: desired {}, real {} counts", one.time_s,
        one.sample == 0 ? "before the motion" : fmt::format("sample {}", one.sample), one.desired,
        one.real));
  }
  return lines;
}

const lab::ColumnTable& columns() {
  static const lab::ColumnTable all = [] {
    using Table = lab::Columns<Options, Result>;
    using At = Table::At;
    using lab::fixed;
    using lab::general;
    const auto words = [](const At& at) -> const lm628::Words& { return at.sample.words; };
    Table t;
    t.add({"t_s", "s", 1e-8, fixed(8), "time from the start of the run", true},
          [](const At& at) { return at.result.seconds(at.sample.edge); });
    lm628::add_trajectory(t, "", words, false);
    t.add({"theta_count", "count", 1e-3, fixed(4), "true angle of the shaft", true},
          [](const At& at) { return shaft_counts(at.options, at.sample.theta); });
    lm628::add_filter_words(t, "", words, [](const At& at) { return at.sample.host_irq; }, true);
    t.add({"omega_rad_s", "rad/s", 1e-4, general(7), "true speed of the shaft", true},
          [](const At& at) { return at.sample.omega; });
    t.add({"i_A", "A", 1e-5, general(7), "true current of the motor"},
          [](const At& at) { return at.sample.i; });
    t.add({"u_V", "V", 1e-4, general(6),
           "voltage at the motor; of an H-bridge its mean since the sample before"},
          [](const At& at) { return at.sample.volt; });
    return std::move(t).table();
  }();
  return all;
}

}  // namespace trammel::an693
