// SPDX-License-Identifier: Apache-2.0
//
// What Larson publishes of motor and buffer (1974, section III), beside what the run's own settings
// give.
#include <cmath>

#include <fmt/format.h>

#include "machines/larson/machine.hpp"

namespace trammel::larson {
namespace {

struct Published {
  int steps;
  double ms;
};

constexpr Published kMultipleSteps[] = {{1, 2.6}, {3, 6.5},  {7, 15},   {15, 30},
                                        {31, 60}, {63, 100}, {127, 180}};
constexpr double kBand = 0.05;  // of the published value; it has two digits

// Until the last of so many pulses at 4000 PPS has left the buffer [s].
double time_of(const plant::PulseBufferConfig& config, int steps, std::int64_t clock_ps) {
  plant::PulseBufferConfig own = config;
  own.clock_ps = clock_ps;
  plant::PulseBuffer buffer(own);
  const auto gap = static_cast<std::int64_t>(250e6 / static_cast<double>(clock_ps));
  std::int64_t last = 0;
  for (int entered = 0, left = 0; left < steps;) {
    if (entered < steps && entered * gap <= buffer.next()) {
      buffer.enter(entered * gap, 1);
      ++entered;
    } else {
      last = buffer.next();
      left += buffer.pass(last) != 0 ? 1 : 0;
    }
  }
  return cosim::seconds_of(last, clock_ps);
}

// Whether motor, buffer and processor are those of which the figures tell.
bool as_shipped(const Options& options) {
  const plant::PulseBufferConfig a = options.axis.buffer, b;
  const plant::StepperConfig m = options.axis.motor, n;
  return options.processor.access_clk == Options().processor.access_clk &&
         a.dead_s == b.dead_s && a.start == b.start && a.rise == b.rise && a.brake == b.brake &&
         m.inertia == n.inertia && m.stiffness_2 == n.stiffness_2 &&
         m.stiffness_3 == n.stiffness_3;
}

}  // namespace

std::vector<lab::Figure> published_figures(const Options& options) {
  std::vector<lab::Figure> list;
  const bool judged = as_shipped(options);
  const auto add = [&](std::string id, std::string row, double value, double printed) {
    lab::Figure f = lab::figure(std::move(id), std::move(row), "", value, "ms", 2);
    f.printed = printed;
    if (judged) {
      f.expected = printed;
      f.tolerance = kBand * printed;
    }
    f.source = "Larson 1974, section III";
    list.push_back(std::move(f));
  };
  for (const Published& one : kMultipleSteps) {
    add(fmt::format("multiple_step.{}_ms", one.steps),
        fmt::format("{} steps at 4000 PPS", one.steps),
        1e3 * time_of(options.axis.buffer, one.steps, options.axis.clock_ps), one.ms);
  }
  const plant::StepperConfig& m = options.axis.motor;
  const auto period = [&m](double k) { return 1e3 * 6.283185307179586 * std::sqrt(m.inertia / k); };
  add("oscillation.two_ms", "oscillation, two phases on", period(m.stiffness_2), 11.5);
  add("oscillation.three_ms", "oscillation, three phases on", period(m.stiffness_3), 8.6);
  return list;
}

}  // namespace trammel::larson
