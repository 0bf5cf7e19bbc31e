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

std::string what_missed(const Options& options, const Result& result) {
  const bool failed = result.end == cosim::EndReason::kFault;
  for (std::size_t k = 0; k < 2; ++k) {
    // A table whose switch fails is driven into its stop: what it loses there is no news.
    const auto& slips = result.slips[k];
    if (slips.empty() || (failed && slips.front().at_stop)) continue;
    return losses(options, result, k) + (failed ? "; " + result.fault : "");
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
