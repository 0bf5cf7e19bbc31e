// SPDX-License-Identifier: Apache-2.0
//
// A straight stroke or a quarter arc in equal steps. The last step ends exactly at the nominal end.
// The step of a stroke is given: a division of 64 bits takes a small core some 1,000 clocks, so
// that a path has it done before a service routine needs it.
#pragma once

#include <cstdint>

#include "sw_nios/path/q32.hpp"

namespace trammel::sw {

class Segment {
 public:
  constexpr Segment() = default;
  // Of arcs whose steps turn by this: Rotation::per_turn(4 * ticks).
  constexpr explicit Segment(Rotation turn) : turn_(turn) {}

  // The n-th part of a way, towards zero: that of -way is its opposite.
  static constexpr Q32 part(Q32 way, std::uint32_t n) { return way / static_cast<Q32>(n); }

  constexpr void begin_stroke(Vec from, Vec to, Vec step, std::uint32_t ticks) {
    at_ = from;
    end_ = to;
    step_ = step;
    left_ = ticks;
    is_arc_ = false;
  }

  // Counter-clockwise from center + radius.
  constexpr void begin_quarter_arc(Vec center, Vec radius, std::uint32_t ticks) {
    center_ = center;
    at_ = radius;
    end_ = center + quarter_left(radius);
    left_ = ticks;
    is_arc_ = true;
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
