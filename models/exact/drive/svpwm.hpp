// SPDX-License-Identifier: Apache-2.0
//
// Space vector modulation (specification section 8). Twin of rtl/drive/svpwm.sv.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "models/exact/drive/carrier.hpp"
#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class Svpwm {
 public:
  struct In {
    std::int32_t v_alpha = 0, v_beta = 0;  // 2048 = V_dc / sqrt 3
    std::uint32_t carrier = 0;
  };
  struct Out {
    std::int32_t cmp_a = 781, cmp_b = 781, cmp_c = 781;
    std::int32_t sector = 0;
  };

  Svpwm() : Svpwm(kCarrierClockHz) {}
  explicit Svpwm(std::uint32_t clock_hz) {
    carrier_clock(clock_hz);
    for (std::uint32_t carrier = 0; carrier < scale_.size(); ++carrier) {
      const std::uint32_t top = cmp_max(carrier, clock_hz);
      const bool coarse = carrier == kCarrier8kHz;
      const std::int64_t beta = std::int64_t{top} * (coarse ? 4 : 8);
      scale_[carrier] = {beta, fixed::rs(beta * kRoot3, 16), static_cast<std::int32_t>(top),
                         coarse ? 7 : 8};
    }
  }

  void reset() {}

  Out step(const In& in) const {
    const Scale& scale = scale_[in.carrier];
    const std::int64_t x = fixed::rs(in.v_beta * scale.beta, 8);    // Q6
    const std::int64_t y = fixed::rs(in.v_alpha * scale.alpha, 8);  // Q6
    const std::int64_t big_x = 2 * x, big_y = x + y, big_z = x - y;         // Q7
    // Signs of the three voltages of Kung eq. 8
    const int sector = (x > 0 ? 1 : 0) + (big_z < 0 ? 2 : 0) + (big_y < 0 ? 4 : 0);
    switch (sector) {
      case 1: return place(sector, times(scale, big_z, big_y), 1, 0, 2);
      case 2: return place(sector, times(scale, big_y, -big_x), 0, 2, 1);
      case 3: return place(sector, times(scale, -big_z, big_x), 0, 1, 2);
      case 4: return place(sector, times(scale, -big_x, big_z), 2, 1, 0);
      case 5: return place(sector, times(scale, big_x, -big_y), 2, 0, 1);
      case 6: return place(sector, times(scale, -big_y, -big_z), 1, 2, 0);
      default: return place(sector, times(scale, 0, 0), 0, 1, 2);
    }
  }

 private:
  static constexpr std::int64_t kRoot3 = 113'512;  // 2^16 sqrt 3

  // Of the carrier; `bits` fractional bits of twice an off-time, one less in all words at 8 kHz.
  struct Scale {
    std::int64_t beta = 0, alpha = 0;
    std::int32_t full = 0;
    int bits = 0;
  };

  struct Pattern {
    std::int32_t cmp[3];  // off-times a, b, c
  };

  static std::int32_t count(std::int64_t x, int s) {
    return static_cast<std::int32_t>(fixed::rs(x, s));
  }

  static Pattern times(const Scale& scale, std::int64_t t1, std::int64_t t2) {
    const std::int64_t sum = t1 + t2;
    // Twice the shortest off-time
    const std::int64_t a = (std::int64_t{scale.full} << (scale.bits - 1)) - sum;
    if (a < 0) {
      const std::int64_t quotient = t1 == sum ? (1 << 14) - 1 : t1 * (1 << 14) / sum;
      return {{0, count(quotient * scale.full, 14), scale.full}};
    }
    return {{count(a, scale.bits), count(a + 2 * t1, scale.bits),
             count(a + 2 * t1 + 2 * t2, scale.bits)}};
  }

  static Out place(int sector, const Pattern& p, int a, int b, int c) {
    return {p.cmp[a], p.cmp[b], p.cmp[c], sector};
  }

  std::array<Scale, 4> scale_;
};

}  // namespace trammel::exact
