// SPDX-License-Identifier: Apache-2.0
//
// Control words of the spline in the chip from points: C_n = p_n - (p_(n-1) - 2 p_n + p_(n+1))/6.
// The spline smooths its words by as much, so that the set point passes through the points.
#pragma once

#include <cstdint>

#include "sw_nios/path/q32.hpp"

namespace trammel::sw {

// 10923/65536 is a sixth; halves are rounded up.
constexpr std::int32_t prefilter(std::int32_t before, std::int32_t now, std::int32_t next) {
  const std::int64_t bend = std::int64_t{before} - 2 * std::int64_t{now} + next;
  return static_cast<std::int32_t>(now - ((10923 * bend + (1 << 15)) >> 16));
}

// One point in, the word of the point before it out. Both Q8.
class Prefilter {
 public:
  // At rest at `start`.
  constexpr explicit Prefilter(Point start) : before_(start), now_(start) {}

  constexpr Point step(Point next) {
    const Point c{prefilter(before_.x, now_.x, next.x), prefilter(before_.y, now_.y, next.y)};
    before_ = now_;
    now_ = next;
    return c;
  }

 private:
  Point before_, now_;
};

}  // namespace trammel::sw
