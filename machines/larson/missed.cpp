// SPDX-License-Identifier: Apache-2.0
//
// Whether the table is where its program has it, by the true places of its rotors.
#include <fmt/format.h>

#include <cmath>

#include "machines/larson/machine.hpp"

namespace trammel::larson {
namespace {

char name_of_axis(std::size_t axis) { return axis == 0 ? 'X' : 'Y'; }

// The first loss: "X lost 10 steps at 1234, 0.512 s into the run".
std::string first_loss(const Options& options, const Result& result, std::size_t axis) {
  for (const Event& one : result.happened) {
    if (one.axis != static_cast<int>(axis) || one.what.find("lost") == std::string::npos) continue;
    return fmt::format("; the first at step {:.0f}, {:.3f} s into the run", one.at,
                       cosim::seconds_of(one.edge, options.axis.clock_ps));
  }
  return "";
}

}  // namespace

std::string what_missed(const Options& options, const Result& result) {
  for (std::size_t k = 0; k < 2; ++k) {
    if (result.lost[k] == 0) continue;
    return fmt::format("{} lost {} steps{}", name_of_axis(k), result.lost[k],
                       first_loss(options, result, k));
  }
  if (!result.calibrated) return "";
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
