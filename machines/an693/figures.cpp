// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine an693 is judged by, and the columns of its trace.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "machines/an693/machine.hpp"
#include "parts/lm628/columns.hpp"

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
      m.settled_s = static_cast<double>(sample) * kSampleS;
    }
    if (s.host_irq && !irq) {
      result.interrupts.push_back(
          {sample, lab::seconds_of(s.edge), w.position >> 16, w.actual, w.status});
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
  const std::int64_t target = desired(all.size() - 1);
  std::int64_t travel = 0;
  std::size_t stood = 0;  // samples at the end
  for (std::size_t k = 0; k < all.size(); ++k) {
    stood = desired(k) == target ? stood + 1 : 0;
    travel = std::max(travel, std::abs(desired(k)));
  }
  using Program = sw::An693Program;
  const bool goes = options.program == Program::kAbsolute || options.program == Program::kRelative;
  if (goes && target != options.position) {
    return fmt::format("the trajectory ended at {} counts, not at {}", target, options.position);
  }
  const bool held = options.program == Program::kHold;
  double band = options.reached_counts;
  if (band == 0) band = held ? 50 : std::clamp(static_cast<double>(travel) / 4, 3.0, 50.0);
  const auto off_target = [&](std::size_t k) {  // the part counts modulo 2^32
    return std::remainder(shaft_counts(options, all[k].theta) - static_cast<double>(target),
                          4294967296.0);
  };
  double low = off_target(all.size() - 1), high = low;
  for (std::size_t k = all.size() - std::max<std::size_t>(1, stood / 2); k < all.size(); ++k) {
    low = std::min(low, off_target(k));
    high = std::max(high, off_target(k));
  }
  if (high - low > band) {
    return fmt::format("the shaft moves by {:.0f} counts at the end", high - low);
  }
  const double off = (low + high) / 2;
  if (held || std::abs(off) <= band) return "";  // a held shaft gives way to the torque
  return fmt::format("the shaft is {:.0f} counts from the target of {}", std::abs(off),
                     target);
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
  add(figure("motion.time_s", "motion", "", samples * kSampleS, "s", 4), "Motion");
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
          [](const At& at) { return lab::seconds_of(at.sample.edge); });
    lm628::add_trajectory(t, "", words, false);
    t.add({"theta_count", "count", 1e-3, fixed(4), "true angle of the shaft", true},
          [](const At& at) { return shaft_counts(at.options, at.sample.theta); });
    lm628::add_filter_words(t, "", words, [](const At& at) { return at.sample.host_irq; }, true);
    t.add({"omega_rad_s", "rad/s", 1e-4, general(7), "true speed of the shaft", true},
          [](const At& at) { return at.sample.omega; });
    t.add({"i_A", "A", 1e-5, general(7), "true current of the motor"},
          [](const At& at) { return at.sample.i; });
    t.add({"u_V", "V", 1e-4, general(6), "voltage at the motor"},
          [](const At& at) { return at.sample.volt; });
    return std::move(t).table();
  }();
  return all;
}

}  // namespace trammel::an693
