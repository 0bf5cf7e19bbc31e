// SPDX-License-Identifier: Apache-2.0
//
// Star (specification section 10): equal strokes, each turned left by turns/strokes of a revolution
// from the previous one; the first runs along +x. Five strokes and three turns give directions of
// 0, 216, 72, 288, 144 degrees; four strokes and one turn give a square. The last stroke ends at
// the start.
//
// Where the next stroke leads is worked out during the one before, a rotation or a division a
// point: where a stroke has more than 4 * turns + 2 points, none of them takes a small core long.
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
      : setup_(setup), quarter_step_(Rotation::per_turn(4 * setup.strokes)), laps_(laps) {
    aim();
    while (!aimed()) aim_further();
  }

  constexpr std::uint32_t lap_ticks() const { return setup_.strokes * setup_.stroke_ticks; }
  constexpr std::uint32_t size() const { return laps_ * lap_ticks() + 1; }
  constexpr Point start() const { return to_counts(setup_.start); }

  constexpr Point next() {
    if (!started_) {
      started_ = true;
      return start();
    }
    if (segment_.ended()) {
      begin_stroke();
    } else if (!aimed()) {
      aim_further();
    }
    return to_counts(segment_.next());
  }

 private:
  constexpr void begin_stroke() {
    while (!aimed()) aim_further();
    segment_.begin_stroke(corner_, to_, step_, setup_.stroke_ticks);
    corner_ = to_;
    stroke_ = stroke_ + 1 < setup_.strokes ? stroke_ + 1 : 0;
    aim();
  }

  // Kung eq. 39 to 43, one stroke each: from corner_ along edge_.
  constexpr void aim() {
    divisions_ = 2;
    rotations_ = 4 * setup_.turns;
    if (stroke_ != 0) return;
    rotations_ = 0;
    corner_ = setup_.start;
    edge_ = {setup_.edge, 0};
  }

  constexpr bool aimed() const { return divisions_ == 0; }

  constexpr void aim_further() {
    if (rotations_ != 0) {
      edge_ = quarter_step_(edge_);
      --rotations_;
    } else if (divisions_ == 2) {
      to_ = stroke_ + 1 < setup_.strokes ? corner_ + edge_ : setup_.start;
      step_.x = Segment::part(to_.x - corner_.x, setup_.stroke_ticks);
      divisions_ = 1;
    } else {
      step_.y = Segment::part(to_.y - corner_.y, setup_.stroke_ticks);
      divisions_ = 0;
    }
  }

  Setup setup_;
  Rotation quarter_step_;  // by a quarter of 1/strokes revolution: small enough for any star
  Segment segment_;
  Vec corner_, to_;  // of the next stroke
  Vec edge_, step_;
  std::uint32_t rotations_ = 0, divisions_ = 0;  // that are left to do
  std::uint32_t laps_;
  std::uint32_t stroke_ = 0;  // the next one
  bool started_ = false;
};

}  // namespace trammel::sw
