// SPDX-License-Identifier: Apache-2.0
#include "machines/gantry/lost_count.hpp"

#include <fmt/format.h>

#include <cmath>

namespace trammel::gantry {

void LostCount::follow(const Look& now, const TrackPlant& plant, double period,
                       std::uint32_t restarts, std::int64_t clock_ps) {
  if (!now.words.known || lost_s_) return;
  const double from = plant.axis().seen(now.edge).x - now.words.position * period / 16384;
  if (since_ != restarts) {
    since_ = restarts;
    from_ = from;
  }
  if (std::fabs(from - from_) < period / 2) return;
  lost_s_ = cosim::seconds_of(now.edge, clock_ps);
  lost_mm_ = 1e3 * std::fabs(from - from_);
}

std::string LostCount::lost() const {
  if (!lost_s_) return "";
  return fmt::format("the observer has lost a stripe: at {:.3f} s it was {:.2f} mm off the cart",
                     *lost_s_, lost_mm_);
}

}  // namespace trammel::gantry
