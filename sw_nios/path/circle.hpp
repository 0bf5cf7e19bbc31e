// SPDX-License-Identifier: Apache-2.0
//
// Circle (specification section 10): x = cx + r sin(theta), y = cy + r cos(theta), theta from 0 in
// equal steps; starts at the top, clockwise. size() = laps * ticks + 1 points; every lap ends
// exactly at its start.
#pragma once

#include <cstdint>

#include "sw_nios/path/q32.hpp"

namespace trammel::sw {

class Circle {
 public:
  struct Setup {
    Vec center{from_counts(50000), from_counts(50000)};
    Q32 radius = from_counts(20000);
    std::uint32_t ticks = 628;  // steps per lap, 4..kMaxTicks
  };

  constexpr Circle(const Setup& setup, std::uint32_t laps)
      : setup_(setup),
        step_(Rotation::per_turn(setup.ticks).inverse()),
        radius_{0, setup.radius},
        laps_(laps) {}

  constexpr std::uint32_t size() const { return laps_ * setup_.ticks + 1; }
  constexpr Point start() const { return to_counts(setup_.center + Vec{0, setup_.radius}); }

  constexpr Point next() {
    const Point point = to_counts(setup_.center + radius_);
    if (++tick_ >= setup_.ticks) {
      tick_ = 0;
      radius_ = {0, setup_.radius};
    } else {
      radius_ = step_(radius_);  // Kung eq. 28, 29
    }
    return point;
  }

 private:
  Setup setup_;
  Rotation step_;
  Vec radius_;
  std::uint32_t laps_;
  std::uint32_t tick_ = 0;
};

}  // namespace trammel::sw
