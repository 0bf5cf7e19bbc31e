// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/motion/timebase.sv.
#pragma once

#include <cstdint>

#include "models/exact/drive/carrier.hpp"
#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class Timebase {
 public:
  struct In {
    std::uint8_t irq_period = 4;  // [position ticks], 0 acts as 1
    std::uint32_t carrier = 0;
    std::uint32_t rate = 1;       // of the position ticks
  };

  struct Out {
    std::uint32_t carrier;  // of this period
    std::uint32_t phase;
    bool tick_cur;
    bool tick_pos;
    bool tick_irq;
    std::uint32_t tick_count;
    bool quiescent;
  };

  Timebase() : Timebase(kCarrierClockHz) {}
  explicit Timebase(std::uint32_t clock_hz) : clock_hz_(carrier_clock(clock_hz)) {}

  void reset() { *this = Timebase(clock_hz_); }

  // What the ports show before the next edge.
  Out out() const {
    const bool cur = timer_.count() == 0;
    const bool pos = cur && cur_ == 0;
    const bool irq = pos && irq_ == 0;
    const std::uint32_t phase = cur ? 0 : pwm_period(carrier_, clock_hz_) - timer_.count();
    return {carrier_, phase, cur, pos, irq, tick_count_, !cur};
  }

  Out step(const In& in) {
    const Out now = out();
    if (now.tick_pos) {
      cur_ = ticks_of_position(in.carrier, in.rate) - 1;
    } else if (now.tick_cur) {
      --cur_;
    }
    if (now.tick_irq) {
      irq_ = in.irq_period == 0 ? 0U : in.irq_period - 1U;
    } else if (now.tick_pos) {
      --irq_;
    }
    if (now.tick_pos) ++tick_count_;
    timer_.step({now.tick_cur, pwm_period(in.carrier, clock_hz_) - 1});
    if (now.tick_cur) carrier_ = in.carrier;
    return out();
  }

  Gap next() const { return timer_.next({out().tick_cur, 0}); }

  void advance(Gap n) { timer_.advance(n); }

 private:
  std::uint32_t clock_hz_;
  Timer timer_;
  std::uint32_t carrier_ = 0;
  std::uint32_t cur_ = 0;  // ticks of the carrier until the position tick
  std::uint32_t irq_ = 0;  // position ticks until the interrupt
  std::uint32_t tick_count_ = 0;
};

}  // namespace trammel::exact
