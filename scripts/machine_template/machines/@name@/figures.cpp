// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine @name@ is judged by, and what of it is recorded.
#include <algorithm>
#include <cmath>

#include "machines/@name@/machine_members.hpp"
#include "machines/@name@/record.hpp"

namespace trammel::@name@ {
namespace {

constexpr double kSettled = 0.05;  // of the wanted speed
constexpr double kReached = 0.01;

}  // namespace

std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& run) {
  const auto& options = static_cast<const Options&>(settings);
  const auto& result = static_cast<const Result&>(run);
  const double wanted = wanted_rev_s(options);
  const std::size_t last = result.samples.size() / 5;  // samples that are at the end
  double sum = 0, beyond = 0, settled = 0, current = 0;
  std::size_t k = 0;
  for (const Sample& s : result.samples) {
    const double speed = rev_s(s);
    if (++k > result.samples.size() - last) sum += speed;
    beyond = std::max(beyond, (speed - wanted) * (wanted < 0 ? -1 : 1));
    if (std::fabs(speed - wanted) > kSettled * std::fabs(wanted)) settled = result.seconds(s.edge);
    current = std::max(current, std::fabs(s.i));
  }
  std::vector<lab::Figure> list;
  const auto add = [&list](lab::Figure f, const char* tile) {
    f.tile = tile;
    list.push_back(std::move(f));
  };
  lab::Figure reached = lab::figure("step.speed_rev_s", "speed at the end", "",
                                    last == 0 ? 0 : sum / static_cast<double>(last), "rev/s");
  if (result.end == cosim::EndReason::kDone) {
    reached.expected = wanted;
    reached.tolerance = kReached * std::fabs(wanted);
    reached.source = "controller.speed_counts";
  }
  add(std::move(reached), "Speed");
  add(lab::figure("step.overshoot_rev_s", "overshoot", "", beyond, "rev/s"), "Overshoot");
  add(lab::figure("step.settled_s", "settled within 5 %", "", settled, "s", 4), "Settled");
  add(lab::figure("step.max_current_A", "largest current", "", current, "A"), "Peak current");
  return list;
}

const lab::ColumnTable& columns() {
  static const lab::ColumnTable all = [] {
    using Table = lab::Columns<Options, Result>;
    using At = Table::At;
    Table t;
    t.add({"t_s", "s", 1e-8, lab::fixed(8), "time from the start of the run", true},
          [](const At& at) { return at.result.seconds(at.sample.edge); });
    t.add({"wanted_rev_s", "rev/s", 1e-3, lab::fixed(4), "speed that is asked for"},
          [](const At& at) { return wanted_rev_s(at.options); });
    t.add({"speed_rev_s", "rev/s", 1e-3, lab::fixed(4), "true speed of the shaft", true},
          [](const At& at) { return rev_s(at.sample); });
    t.add({"duty", "", 1, lab::whole(), "clocks of a PWM period of 2500", true},
          [](const At& at) { return at.sample.duty; });
    t.add({"i_A", "A", 1e-4, lab::fixed(5), "true current of the motor", true},
          [](const At& at) { return at.sample.i; });
    t.add({"count", "count", 1, lab::whole(), "what the chip counted; wraps"},
          [](const At& at) { return at.sample.count; });
    return std::move(t).table();
  }();
  return all;
}

}  // namespace trammel::@name@
