// SPDX-License-Identifier: Apache-2.0
//
// Window (specification section 10): a square whose four corners are cut out by quarter circles
// centred on them. Clockwise from the middle of the left side; nine parts a..i: strokes and arcs
// alternate, the first and the last stroke half as long as the others. Corner n + 1 is corner n
// rotated right by 90 degrees; the arcs themselves run left.
#pragma once

#include <cstdint>

#include "sw_nios/path/segment.hpp"

namespace trammel::sw {

class Window {
 public:
  struct Setup {
    Vec center{from_counts(50000), from_counts(50000)};
    Q32 half_side = from_counts(20000);
    Q32 radius = from_counts(6000);       // < half_side
    std::uint32_t half_stroke_ticks = 100;  // parts a and i; the full strokes take twice as many
    std::uint32_t arc_ticks = 67;
  };

  constexpr Window(const Setup& setup, std::uint32_t laps)
      : setup_(setup),
        step_(Segment::part(setup.half_side - setup.radius, setup.half_stroke_ticks)),
        segment_(Rotation::per_turn(4 * setup.arc_ticks)),
        laps_(laps) {}

  constexpr std::uint32_t lap_ticks() const {
    return 8 * setup_.half_stroke_ticks + 4 * setup_.arc_ticks;
  }
  constexpr std::uint32_t size() const { return laps_ * lap_ticks() + 1; }
  constexpr Point start() const { return to_counts(start_point()); }

  constexpr Point next() {
    if (!started_) {
      started_ = true;
      at_ = start_point();
      return to_counts(at_);
    }
    if (segment_.ended()) begin_part();
    at_ = segment_.next();
    return to_counts(at_);
  }

 private:
  static constexpr int kParts = 9;

  constexpr Vec start_point() const { return setup_.center - Vec{setup_.half_side, 0}; }

  constexpr void begin_part() {
    if (part_ == 0) {
      corner_ = {-setup_.half_side, setup_.half_side};
      radius_ = {0, -setup_.radius};
      stroke_step_ = {0, step_};
    }
    // Kung eq. 31, 33, 35, 37: arcs b, d, f, h
    if (part_ % 2 == 1) {
      segment_.begin_quarter_arc(setup_.center + corner_, radius_, setup_.arc_ticks);
      corner_ = quarter_right(corner_);
      radius_ = quarter_right(radius_);
      stroke_step_ = quarter_right(stroke_step_);
    } else if (part_ == kParts - 1) {  // Kung eq. 38
      segment_.begin_stroke(at_, start_point(), stroke_step_, setup_.half_stroke_ticks);
    } else {
      const std::uint32_t halves = part_ == 0 ? 1 : 2;  // Kung eq. 30, 32, 34, 36: a, c, e, g
      segment_.begin_stroke(at_, setup_.center + corner_ + radius_, stroke_step_,
                            halves * setup_.half_stroke_ticks);
    }
    part_ = (part_ + 1) % kParts;
  }

  Setup setup_;
  Q32 step_;  // of all strokes: a full one is twice as long in twice as many steps
  Segment segment_;
  Vec at_;
  Vec corner_;  // from the window's centre: where the next arc is centred
  Vec radius_;  // from that corner: where the next arc begins
  Vec stroke_step_;  // of the next stroke
  std::uint32_t laps_;
  int part_ = 0;
  bool started_ = false;
};

}  // namespace trammel::sw
