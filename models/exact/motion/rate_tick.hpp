// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/motion/rate_tick.sv.
#pragma once

#include <cstdint>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class RateTick {
 public:
  explicit RateTick(std::uint32_t clock_hz = 50'000'000, std::uint32_t rate_hz = 4612)
      : clock_(clock_hz), rate_(rate_hz) {}

  void reset() {
    period_.reset();
    rest_ = 0;
  }

  bool tick() const { return period_.count() == 1; }  // the present edge

  void step() {
    if (period_.count() > 1) {
      period_.step({});
      return;
    }
    const std::uint32_t sum = rest_ + clock_ % rate_;
    rest_ = sum % rate_;
    period_.step({true, clock_ / rate_ + sum / rate_});
  }

  bool quiescent() const { return period_.count() > 1; }
  Gap next() const { return quiescent() ? period_.next({}) : 0; }
  void advance(Gap n) { period_.advance(n); }

 private:
  std::uint32_t clock_, rate_;
  Timer period_;
  std::uint32_t rest_ = 0;
};

}  // namespace trammel::exact
