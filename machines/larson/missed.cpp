// SPDX-License-Identifier: Apache-2.0
//
// Whether the table is where its program has it, by the true places of its rotors.
#include <fmt/format.h>

#include <cmath>

#include "machines/larson/machine.hpp"

namespace trammel::larson {
namespace {

char name_of_axis(std::size_t axis) { return axis == 0 ? 'X' : 'Y'; }

// "X lost 10 steps in 3 slips; the first at step 1234, 0.512 s into the run".
std::string losses(const Options& options, const Result& result, std::size_t axis) {
  const auto& slips = result.slips[axis];
  return fmt::format("{} lost {} steps{}; the first at step {:.0f}, {:.3f} s into the run",
                     name_of_axis(axis), result.lost[axis],
                     slips.size() > 1 ? fmt::format(" in {} slips", slips.size()) : "",
                     slips.front().at,
                     cosim::seconds_of(slips.front().edge, options.axis.clock_ps));
}

}  // namespace

std::string breach_text(const plant::StepBreach& breach, std::int64_t clock_ps) {
  const double us = 1e6 * cosim::seconds_of(breach.clocks, clock_ps);
  switch (breach.kind) {
    case plant::StepBreach::Kind::kWidth:
      return fmt::format("its pulse was {:.2f} us wide, below translator.width_us", us);
    case plant::StepBreach::Kind::kSetup:
      return fmt::format("direction turned {:.2f} us before its pulse, below translator.setup_us",
                         us);
    default:
      return fmt::format("direction turned {:.2f} us behind the edge of its pulse, below "
                         "translator.hold_us", us);
  }
}

std::string what_missed(const Options& options, const Result& result) {
  const bool failed = result.end == cosim::EndReason::kFault;
  for (std::size_t k = 0; k < 2; ++k) {
    // A table whose switch fails is driven into its stop: what it loses there is no news.
    const auto& slips = result.slips[k];
    if (slips.empty() || (failed && slips.front().at_stop)) continue;
    return losses(options, result, k) + (failed ? "; " + result.fault : "");
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& breaches = result.breaches[k];
    if (breaches.empty()) continue;
    return fmt::format("{} pulse{} of {} made no step; the first {:.3f} s into the run, as {}",
                       breaches.size(), breaches.size() == 1 ? "" : "s", name_of_axis(k),
                       cosim::seconds_of(breaches.front().edge, options.axis.clock_ps),
                       breach_text(breaches.front(), options.axis.clock_ps)) +
           (failed ? "; " + result.fault : "");
  }
  if (failed || !result.calibrated) return "";
  for (std::size_t k = 0; k < 2; ++k) {
    const double known = k == 0 ? result.known.x : result.known.y;
    const double off = result.end_at[k] - result.origin[k] - known;
    if (std::fabs(off) <= options.reached_steps) continue;
    return fmt::format("{} is {:.1f} steps from {:.0f}, where its program has it "
                       "(run.reached_steps)", name_of_axis(k), off, known);
  }
  return "";
}

}  // namespace trammel::larson
