// SPDX-License-Identifier: Apache-2.0
//
// Whether the observer counts the stripes that pass its sensor.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "machines/gantry/plant.hpp"
#include "machines/gantry/record.hpp"

namespace trammel::gantry {

class LostCount {
 public:
  // The observer against the place that its sensor sees: half a `period` [m] apart it has lost its
  // count. It counts anew from each of the program's `restarts` on.
  void follow(const Look& now, const TrackPlant& plant, double period, std::uint32_t restarts,
              std::int64_t clock_ps);

  std::string lost() const;  // when, and how far it then was off the cart; "": it is not

 private:
  double from_ = 0;  // [m] where it counts from, since which restart, and its first loss
  std::optional<std::uint32_t> since_;
  std::optional<double> lost_s_;
  double lost_mm_ = 0;
};

}  // namespace trammel::gantry
