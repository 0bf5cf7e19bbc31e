// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/drive/force_pwm.sv.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class ForcePwm {
 public:
  static constexpr std::uint32_t kHalf = 3472;  // [clk] of a period
  static constexpr std::uint32_t kScale = 3475;
  using In = std::array<std::int32_t, 2>;  // forces, -1024 to 1023
  struct Out {
    bool pwm = false, negative = false;
  };

  void reset() { *this = ForcePwm(); }

  const std::array<Out, 2>& out() const { return out_; }

  // [clk] on of 2 kHalf.
  static std::uint32_t on_clk(std::int32_t force) { return 2 * half_pulse(force); }

  void step(const In& in) {
    const std::uint32_t count = period_.count();
    for (std::size_t k = 0; k < 2; ++k) {
      out_[k] = {on(k), taken_[k]};
      if (count > 1) continue;
      half_[k] = half_pulse(in[k]);
      taken_[k] = in[k] < 0;
    }
    period_.step({count <= 1, 2 * kHalf});
  }

  bool quiescent() const {
    if (period_.count() <= 1) return false;
    for (std::size_t k = 0; k < 2; ++k) {
      if (out_[k].pwm != on(k) || out_[k].negative != taken_[k]) return false;
    }
    return true;
  }

  Gap next() const {
    const std::uint32_t count = period_.count();
    if (count <= 1) return 0;
    Gap next = period_.next({});
    for (const std::uint32_t half : half_) {
      Gap far = kGapMax - 1;
      if (count > kHalf + half) {
        far = count - (kHalf + half);
      } else if (count > kHalf - half) {
        far = count - (kHalf - half);
      }
      next = std::min({next, far, kGapMax - 1});
    }
    return next;
  }

  void advance(Gap n) { period_.advance(n); }

 private:
  static std::uint32_t half_pulse(std::int32_t force) {
    const auto size = static_cast<std::uint32_t>(std::min(std::abs(force), 1023));
    return (size * kScale + 512) >> 10;
  }
  bool on(std::size_t k) const {
    const std::uint32_t count = period_.count();
    return count > kHalf - half_[k] && count <= kHalf + half_[k];
  }

  Timer period_;
  std::array<std::uint32_t, 2> half_{};
  std::array<bool, 2> taken_{};
  std::array<Out, 2> out_{};
};

}  // namespace trammel::exact
