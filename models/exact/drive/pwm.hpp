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
  struct In {
    std::uint32_t period = 3125;  // of the carrier [clk]
    std::uint32_t phase = 0;      // below it
    bool load = false;
    bool enable = false;
    std::array<std::uint32_t, 3> cmp{};
  };

  static std::uint32_t triangle(std::uint32_t period, std::uint32_t phase) {
    return std::min(phase, period - phase);
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
      const std::uint32_t rest = in.period - in.phase;
      if (in.phase <= cmp) {
        gap = std::min(gap, clipped(cmp - in.phase + 1));
      } else if (rest > cmp) {
        gap = std::min(gap, clipped(rest - cmp));
      }
    }
    return gap;
  }

 private:
  static constexpr std::uint32_t kNever = 4095;  // compare value that never switches on

  // Clocks as a gap that is not "none".
  static Gap clipped(std::uint32_t clocks) { return std::min<Gap>(clocks, kGapMax - 1); }

  unsigned wanted(const In& in) const {
    unsigned on = 0;
    for (unsigned i = 0; i < 3; ++i) {
      if (in.enable && triangle(in.period, in.phase) > cmp_[i]) on |= 1U << i;
    }
    return on;
  }

  std::array<std::uint32_t, 3> cmp_{kNever, kNever, kNever};
  unsigned on_ = 0;
};

}  // namespace trammel::exact
