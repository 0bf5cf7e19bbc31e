// SPDX-License-Identifier: Apache-2.0
//
// Straight line at constant speed; further passes go back and forth.
#pragma once

#include <cstdint>

#include "sw_nios/path/segment.hpp"

namespace trammel::sw {

class Line {
 public:
  struct Setup {
    Vec from{from_counts(20000), from_counts(20000)};
    Vec to{from_counts(80000), from_counts(80000)};
    std::uint32_t ticks = 500;  // per pass
  };

  constexpr Line(const Setup& setup, std::uint32_t passes)
      : setup_(setup),
        step_{Segment::part(setup.to.x - setup.from.x, setup.ticks),
              Segment::part(setup.to.y - setup.from.y, setup.ticks)},
        passes_(passes) {}

  constexpr std::uint32_t size() const { return passes_ * setup_.ticks + 1; }
  constexpr Point start() const { return to_counts(setup_.from); }

  constexpr Point next() {
    if (!started_) {
      started_ = true;
      return start();
    }
    if (segment_.ended()) {
      if (back_) {
        segment_.begin_stroke(setup_.to, setup_.from, Vec{} - step_, setup_.ticks);
      } else {
        segment_.begin_stroke(setup_.from, setup_.to, step_, setup_.ticks);
      }
      back_ = !back_;
    }
    return to_counts(segment_.next());
  }

 private:
  Setup setup_;
  Vec step_;  // forth
  Segment segment_;
  std::uint32_t passes_;
  bool started_ = false;
  bool back_ = false;
};

}  // namespace trammel::sw
