// SPDX-License-Identifier: Apache-2.0
//
// Square wave of the step test (specification sections 10 and 12): `high` for half_ticks points,
// then `low` for as many, in each period. The table rests at `low` before the first step, which is
// point 0. A half period of 375 ms is 187.5 interrupts of 2 ms, so it is written at 2 kHz: 750
// points. Swapping low and high reverses the polarity; low = -high is the symmetric wave.
#pragma once

#include <cstdint>

#include "sw_nios/path/q32.hpp"

namespace trammel::sw {

class Square {
 public:
  struct Setup {
    Point low{0, 0};
    Point high{2000, 2000};
    std::uint32_t half_ticks = 750;
  };

  constexpr Square(const Setup& setup, std::uint32_t periods) : setup_(setup), periods_(periods) {}

  constexpr std::uint32_t size() const { return 2 * periods_ * setup_.half_ticks; }
  constexpr Point start() const { return setup_.low; }

  constexpr Point next() {
    const Point point = tick_ < setup_.half_ticks ? setup_.high : setup_.low;
    tick_ = tick_ + 1 < 2 * setup_.half_ticks ? tick_ + 1 : 0;
    return point;
  }

 private:
  Setup setup_;
  std::uint32_t periods_;
  std::uint32_t tick_ = 0;
};

}  // namespace trammel::sw
