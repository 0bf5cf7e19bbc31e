// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/motion/step_clock.sv.
#pragma once

#include <cstdint>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class StepClock {
 public:
  struct Out {
    bool tick = false;  // the present edge, by itself
    bool half = false;
    Gap next_tick = 0;  // [clk] before that of the next tick
    Gap next_half = 0;
  };

  explicit StepClock(std::uint32_t inc = 3, std::uint32_t mod = 625) : inc_(inc), mod_(mod) {}

  void reset() { acc_ = 0; }

  // Whole clocks from tick to tick, at least.
  std::uint32_t tick_clk() const { return mod_ / inc_; }

  Out out() const {
    const std::uint32_t half = mod_ / 2;
    const bool first = acc_ < half;
    const Gap next_tick = (mod_ - 1 - acc_) / inc_;
    return {acc_ >= mod_ - inc_, first && acc_ >= half - inc_, next_tick,
            first ? (half - 1 - acc_) / inc_ : next_tick};
  }

  // Ticks in the n clocks from the present edge on.
  Gap ticks(Gap n) const { return (acc_ + inc_ * n) / mod_; }

  void step() { advance(1); }
  void advance(Gap n) { acc_ = (acc_ + inc_ * n) % mod_; }

 private:
  std::uint32_t inc_, mod_;
  std::uint32_t acc_ = 0;
};

}  // namespace trammel::exact
