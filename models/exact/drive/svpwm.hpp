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

  void reset() {}

  Out step(const In& in) const {
    const Scale scale{kBeta[in.carrier], kAlpha[in.carrier],
                      static_cast<std::int32_t>(cmp_max(in.carrier)),
                      in.carrier == kCarrier8kHz ? 7 : 8};
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
  static constexpr std::array<std::int64_t, 4> kBeta{12496, 12500, 10000, 5000};
  static constexpr std::array<std::int64_t, 4> kAlpha{21644, 21651, 17321, 8660};

  // Of the carrier; `bits` fractional bits of twice an off-time, one less in all words at 8 kHz.
  struct Scale {
    std::int64_t beta, alpha;
    std::int32_t full;
    int bits;
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
};

}  // namespace trammel::exact
