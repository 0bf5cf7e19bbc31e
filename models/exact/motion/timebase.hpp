// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/motion/timebase.sv.
#pragma once

#include <cstdint>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class Timebase {
 public:
  static constexpr std::uint32_t kPeriod = 3125;  // [clk] 16 kHz at 50 MHz

  struct In {
    std::uint8_t irq_period = 4;  // [2 kHz ticks], 0 acts as 1
  };

  struct Out {
    std::uint32_t phase;
    bool tick_cur;
    bool tick_pos;
    bool tick_irq;
    std::uint32_t tick_count;
    bool quiescent;
  };

  void reset() { *this = Timebase(); }

  // What the ports show before the next edge.
  Out out() const {
    const bool cur = timer_.count() == 0;
    const bool pos = cur && cur_ == 0;
    const bool irq = pos && irq_ == 0;
    return {cur ? 0 : kPeriod - timer_.count(), cur, pos, irq, tick_count_, !cur};
  }

  Out step(const In& in) {
    const Out now = out();
    if (now.tick_cur) cur_ = (cur_ + 1) % 8;
    if (now.tick_irq) {
      irq_ = in.irq_period == 0 ? 0U : in.irq_period - 1U;
    } else if (now.tick_pos) {
      --irq_;
    }
    if (now.tick_pos) ++tick_count_;
    timer_.step({now.tick_cur, kPeriod - 1});
    return out();
  }

  Gap next() const { return timer_.next({out().tick_cur, kPeriod - 1}); }

  void advance(Gap n) { timer_.advance(n); }

 private:
  Timer timer_;
  std::uint32_t cur_ = 0;  // 16 kHz ticks since the last 2 kHz tick, modulo 8
  std::uint32_t irq_ = 0;  // 2 kHz ticks until the interrupt
  std::uint32_t tick_count_ = 0;
};

}  // namespace trammel::exact
