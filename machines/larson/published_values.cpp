// SPDX-License-Identifier: Apache-2.0
//
// What Larson publishes of rates, motor and buffer (1974, Table I and section III), beside what a
// run had of them: rates of 64 pulses of its chip, moves through its buffer, swings of its rotors.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "machines/larson/machine_members.hpp"

namespace trammel::larson {
namespace {

struct PublishedTime {
  int steps;
  double ms;
};

constexpr PublishedTime kMultipleSteps[] = {{1, 2.6}, {3, 6.5},  {7, 15},   {15, 30},
                                            {31, 60}, {63, 100}, {127, 180}};
// Table I: rate counter, in octal, and PPS, rounded to whole ones. 7650 is a misprint: 3000 PPS are
// 7660 by his own formula.
struct Rate {
  std::uint32_t code;
  double pps;
};
constexpr Rate kRates[] = {{01000, 67},   {02000, 78},   {03000, 94},   {04000, 117},
                           {05000, 156},  {06000, 234},  {07000, 469},  {07100, 536},
                           {07200, 625},  {07300, 750},  {07400, 938},  {07500, 1250},
                           {07550, 1579}, {07600, 1875}, {07650, 3000}, {07700, 3750},
                           {07704, 4000}};
constexpr std::uint32_t kMisprint = 07650;
constexpr double kRounded = 0.51;  // [pulse/s] and a clock in 64 steps

constexpr double kBand = 0.05;  // of the published value; it has two digits

// [s] From the first pulse into a buffer that stood to the last out of it, of a move of so many
// steps at 4000 PPS.
std::optional<double> time_of(const Options& options, const Result& result, int steps) {
  constexpr double kGap = 250e-6, kExact = 0.01;
  for (const auto& moves : result.moves) {
    for (const plant::BufferMove& one : moves) {
      if (one.pulses != steps || one.gone != steps) continue;
      const double came = options.run.seconds(one.entered - one.began);
      if (std::fabs(came - (steps - 1) * kGap) > kExact * steps * kGap) continue;
      return options.run.seconds(one.left - one.began);
    }
  }
  return {};
}

// [s] Mean period of the rotors of a run that swung about the place at which so many phases are on,
// by less than 0.2 step; nothing where they did so for less than two periods.
std::optional<double> ring_of(const Options& options, const Result& result, int phases) {
  constexpr double kMost = 0.2, kLeast = 0.01;  // [step]
  double sum = 0;
  int periods = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    AxisSample last;
    double t_last = 0, risen = -1, most = 0;  // time of the last rising zero
    for (const Sample& s : result.looks) {
      const AxisSample& now = s.axis[k];
      const double t = options.run.seconds(s.edge);
      const bool still = now.waiting == 0 && now.rate == 0 && now.step == last.step &&
                         plant::StepperMotor::phases(now.step) == phases;
      if (!still) risen = -1;
      most = std::max(most, std::fabs(now.angle));
      if (still && last.angle < 0 && now.angle >= 0) {
        const double zero = t_last + (t - t_last) * last.angle / (last.angle - now.angle);
        if (risen >= 0 && most < kMost && most > kLeast) {
          sum += zero - risen;
          ++periods;
        }
        risen = zero;
        most = 0;
      }
      last = now;
      t_last = t;
    }
  }
  if (periods < 2) return {};
  return sum / periods;
}

// Whether motor, buffer and processor are those of which the figures tell.
bool as_shipped(const Options& options) {
  const plant::PulseBufferConfig a = options.axis.buffer, b;
  const plant::StepperConfig m = options.axis.motor, n;
  return options.processor.access_clk == Options().processor.access_clk &&
         a.dead_s == b.dead_s && a.start == b.start && a.rise == b.rise && a.brake == b.brake &&
         m.inertia == n.inertia && m.stiffness_2 == n.stiffness_2 &&
         m.stiffness_3 == n.stiffness_3 && m.damping_2 == n.damping_2 &&
         m.damping_3 == n.damping_3 && m.friction == n.friction &&
         m.torque_share == n.torque_share && !options.fault.any();
}

}  // namespace

std::vector<lab::Figure> published_figures(const Options& options, const Result& result) {
  std::vector<lab::Figure> list;
  const bool judged = as_shipped(options);
  // Rates are the chip's, whatever it drives; times are of his motor, buffer and processor.
  const auto add_figure = [&](lab::Figure f, double printed, std::optional<double> tolerance,
                              const char* source) {
    const bool of_chip = f.unit == "PPS";
    if (judged || of_chip) f.printed = printed;
    if (judged && tolerance) {
      f.expected = printed;
      f.tolerance = *tolerance;
    }
    if (f.printed) f.source = source;
    list.push_back(std::move(f));
  };
  const auto add = [&](std::string id, std::string row, double value, double printed) {
    add_figure(lab::figure(std::move(id), std::move(row), "", value, "ms", 2), printed,
               kBand * printed, "Larson 1974, section III");
  };
  for (const PublishedTime& one : kMultipleSteps) {
    const auto time = time_of(options, result, one.steps);
    if (!time) continue;
    add(fmt::format("multiple_step.{}_ms", one.steps),
        fmt::format("{} step{} at 4000 PPS", one.steps, one.steps == 1 ? "" : "s"), 1e3 * *time,
        one.ms);
  }
  if (const auto two = ring_of(options, result, 2)) {
    add("oscillation.two_ms", "oscillation, two phases on", 1e3 * *two, 11.5);
  }
  if (const auto three = ring_of(options, result, 3)) {
    add("oscillation.three_ms", "oscillation, three phases on", 1e3 * *three, 8.6);
  }
  for (const Rate& one : kRates) {
    const auto rate = result.rates.find(one.code);
    if (rate == result.rates.end()) continue;
    const bool misprint = one.code == kMisprint;
    std::optional<double> tolerance;
    if (!misprint) tolerance = kRounded;
    add_figure(lab::figure(fmt::format("rate.{:o}_pps", one.code),
                           fmt::format("rate {:o}{}", one.code,
                                       misprint ? " (misprint of 7660)" : ""),
                           "", rate->second, "PPS", 1),
               one.pps, tolerance, "Larson 1974, Table I");
  }
  return list;
}

}  // namespace trammel::larson
