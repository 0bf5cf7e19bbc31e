// SPDX-License-Identifier: Apache-2.0
#include "machines/an693/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/an693/machine.hpp"
#include "parts/lm628/columns.hpp"

namespace trammel::an693 {
namespace {

constexpr double kSettledBand = 2.5;  // [count] that a step settles to

}  // namespace

double shaft_counts(const Options& options, const Sample& s) {
  return s.theta / plant::MotorAxis::kTurn * options.plant.counts;
}

Metrics evaluate(const Options& options, const Result& result) {
  Metrics m;
  std::int64_t sample = 0, before = 0;
  int direction = 0;
  bool irq = false, first = true;
  for (const Sample& s : result.samples) {
    const lm628::Words& w = s.words;
    // The desired position follows the real one.
    const bool off = (w.status & sw::lm628_status::kMotorOff) != 0;
    const bool moves = !off && w.position != before;
    if (sample > 0 || moves) ++sample;
    if (moves) {
      first = first && (m.moving_samples == 0 || sample == m.moving_samples + 1);
      m.moving_samples = sample;
      direction = w.position > before ? 1 : -1;
    }
    before = w.position;
    const double beyond =
        (shaft_counts(options, s) - static_cast<double>(w.position) / lm628::kPerCount) * direction;
    // A step moves the desired position within one sample: what counts is where the shaft goes.
    if (sample > 0 && !off) m.overshoot_counts = std::max(m.overshoot_counts, beyond);
    if (first && std::fabs(beyond) > kSettledBand) {
      m.settled_s = static_cast<double>(sample) * kSampleS;
    }
    if (s.host_irq && !irq) {
      m.interrupts.push_back(
          {sample, lab::seconds_of(s.edge), w.position >> 16, w.actual, w.status});
    }
    irq = s.host_irq;
    m.max_error_counts = std::max<std::int64_t>(m.max_error_counts, std::abs(w.error));
    m.max_speed_rev_s = std::max(m.max_speed_rev_s, std::fabs(s.omega) / plant::MotorAxis::kTurn);
    m.max_voltage_V = std::max(m.max_voltage_V, std::fabs(s.volt));
    m.max_current_A = std::max(m.max_current_A, std::fabs(s.i));
  }
  m.moving_s = static_cast<double>(m.moving_samples) * kSampleS;
  return m;
}

std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  auto& result = static_cast<Result&>(run);
  const Metrics m = evaluate(options, result);
  result.interrupts = m.interrupts;
  const bool done = result.end == cosim::EndReason::kDone;
  std::vector<lab::Figure> list;
  const auto add = [&list](lab::Figure f, const char* tile = "", bool shown = true) {
    f.tile = tile;
    f.shown = shown;
    list.push_back(std::move(f));
  };
  using lab::count;
  using lab::figure;
  add(count("motion.samples", "motion", "", static_cast<double>(m.moving_samples), "samples"));
  add(figure("motion.time_s", "motion", "", m.moving_s, "s", 4), "Motion");
  add(count("motion.desired_count", "end position", "desired", result.desired, "counts"), "", done);
  add(count("motion.real_count", "end position", "real", result.real, "counts"), "Real position",
      done);
  add(figure("motion.overshoot_counts", "overshoot", "", m.overshoot_counts, "counts", 2),
      "Overshoot");
  add(figure("motion.settled_s", "first step settled", "", m.settled_s, "s", 4), "",
      options.program == sw::An693Program::kTuning);
  add(count("motion.max_error_counts", "largest error", "",
            static_cast<double>(m.max_error_counts), "counts"),
      "Largest error");
  add(figure("motion.max_speed_rev_s", "largest speed", "", m.max_speed_rev_s, "rev/s"),
      "Top speed");
  add(figure("motion.max_voltage_V", "largest voltage", "", m.max_voltage_V, "V", 2));
  add(figure("motion.max_current_A", "largest current", "", m.max_current_A, "A"), "Peak current");
  add(count("motion.interrupts", "host interrupts", "", static_cast<double>(m.interrupts.size())));
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
          [](const At& at) { return shaft_counts(at.options, at.sample); });
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
