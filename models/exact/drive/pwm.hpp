// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/drive/pwm.sv. The phase comes from the time base, so that it keeps no time itself:
// next() counts edges from the given phase, and the switches hold until then.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class Pwm {
 public:
  static constexpr std::uint32_t kPeriod = 3125;  // [clk]
  static constexpr std::uint32_t kCmpMax = 1562;  // top of the carrier

  struct In {
    std::uint32_t phase = 0;  // 0..3124
    bool load = false;
    bool enable = false;
    std::array<std::uint32_t, 3> cmp{};
  };

  static std::uint32_t carrier(std::uint32_t phase) {
    return phase <= kCmpMax ? phase : kPeriod - phase;
  }

  void reset() { *this = Pwm(); }

  // Bits 0, 1, 2: upper switch of phase a, b, c on.
  unsigned step(const In& in) {
    on_ = wanted(in);
    if (in.load) cmp_ = in.cmp;
    return on_;
  }

  unsigned on() const { return on_; }

  bool quiescent(const In& in) const { return !in.load && wanted(in) == on_; }

  Gap next(const In& in) const {
    Gap gap = kGapMax;
    if (!in.enable) return gap;
    for (const std::uint32_t cmp : cmp_) {
      const std::uint32_t rise = cmp + 1;
      const std::uint32_t fall = kPeriod - cmp;
      if (in.phase < rise) {
        gap = std::min(gap, rise - in.phase);
      } else if (in.phase < fall) {
        gap = std::min(gap, fall - in.phase);
      }
    }
    return gap;
  }

 private:
  unsigned wanted(const In& in) const {
    unsigned on = 0;
    for (unsigned i = 0; i < 3; ++i) {
      if (in.enable && carrier(in.phase) > cmp_[i]) on |= 1U << i;
    }
    return on;
  }

  std::array<std::uint32_t, 3> cmp_{kCmpMax, kCmpMax, kCmpMax};
  unsigned on_ = 0;
};

}  // namespace trammel::exact
