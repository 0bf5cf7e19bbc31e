// SPDX-License-Identifier: Apache-2.0
//
// Star (specification section 10): equal strokes, each turned left by turns/strokes of a revolution
// from the previous one; the first runs along +x. Five strokes and three turns give directions of
// 0, 216, 72, 288, 144 degrees; four strokes and one turn give a square. The last stroke ends at
// the start.
#pragma once

#include <cstdint>

#include "sw_nios/path/segment.hpp"

namespace trammel::sw {

class Star {
 public:
  struct Setup {
    Vec start{from_counts(40000), from_counts(53250)};
    Q32 edge = from_counts(20000);
    std::uint32_t strokes = 5;
    std::uint32_t turns = 3;  // 1..strokes-1
    std::uint32_t stroke_ticks = 182;
  };

  constexpr Star(const Setup& setup, std::uint32_t laps)
      : setup_(setup), quarter_step_(Rotation::per_turn(4 * setup.strokes)), laps_(laps) {}

  constexpr std::uint32_t lap_ticks() const { return setup_.strokes * setup_.stroke_ticks; }
  constexpr std::uint32_t size() const { return laps_ * lap_ticks() + 1; }
  constexpr Point start() const { return to_counts(setup_.start); }

  constexpr Point next() {
    if (!started_) {
      started_ = true;
      return start();
    }
    if (segment_.ended()) begin_stroke();
    return to_counts(segment_.next());
  }

 private:
  constexpr void begin_stroke() {
    if (stroke_ == 0) {
      corner_ = setup_.start;
      edge_ = {setup_.edge, 0};
    }
    // Kung eq. 39 to 43: one stroke each
    const bool last = stroke_ + 1 == setup_.strokes;
    const Vec to = last ? setup_.start : corner_ + edge_;
    segment_ = Segment::stroke(corner_, to, setup_.stroke_ticks);
    corner_ = to;
    for (std::uint32_t i = 0; i < 4 * setup_.turns; ++i) edge_ = quarter_step_(edge_);
    stroke_ = last ? 0 : stroke_ + 1;
  }

  Setup setup_;
  Rotation quarter_step_;  // by a quarter of 1/strokes revolution: small enough for any star
  Segment segment_;
  Vec corner_;
  Vec edge_;
  std::uint32_t laps_;
  std::uint32_t stroke_ = 0;
  bool started_ = false;
};

}  // namespace trammel::sw
