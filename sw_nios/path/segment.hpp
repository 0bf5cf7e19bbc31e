// SPDX-License-Identifier: Apache-2.0
//
// A straight stroke or a quarter arc in equal steps. The last step ends exactly at the nominal end.
#pragma once

#include <cstdint>

#include "sw_nios/path/q32.hpp"

namespace trammel::sw {

class Segment {
 public:
  constexpr Segment() = default;

  static constexpr Segment stroke(Vec from, Vec to, std::uint32_t ticks) {
    Segment s;
    s.at_ = from;
    s.end_ = to;
    s.left_ = ticks;
    const auto n = static_cast<Q32>(ticks);
    s.step_ = {(to.x - from.x) / n, (to.y - from.y) / n};
    return s;
  }

  // Counter-clockwise from center + radius; step = Rotation::per_turn(4 * ticks).
  static constexpr Segment quarter_arc(Vec center, Vec radius, Rotation step, std::uint32_t ticks) {
    Segment s;
    s.center_ = center;
    s.at_ = radius;
    s.end_ = center + quarter_left(radius);
    s.left_ = ticks;
    s.turn_ = step;
    s.is_arc_ = true;
    return s;
  }

  constexpr bool ended() const { return left_ == 0; }

  constexpr Vec next() {
    if (left_ <= 1) {
      left_ = 0;
      return end_;
    }
    --left_;
    at_ = is_arc_ ? turn_(at_) : at_ + step_;
    return is_arc_ ? center_ + at_ : at_;
  }

 private:
  Vec center_;  // arc only
  Vec at_;      // position; for an arc, relative to its centre
  Vec step_;    // stroke only
  Vec end_;
  Rotation turn_;  // arc only
  std::uint32_t left_ = 0;
  bool is_arc_ = false;
};

}  // namespace trammel::sw
