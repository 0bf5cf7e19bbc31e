// SPDX-License-Identifier: Apache-2.0
//
// Voltage limit with priority for the d axis. Twin of rtl/drive/vector_limit.sv.
#pragma once

#include <algorithm>
#include <cstdint>

#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class VectorLimit {
 public:
  struct In {
    std::int32_t v_d = 0, v_q = 0;
  };
  struct Out {
    std::int32_t v_d = 0, v_q = 0;
    bool limited = false;
  };

  void reset() {}

  Out step(const In& in) const {
    const auto v_d = static_cast<std::int32_t>(fixed::clip(in.v_d, -kRadius, kRadius));
    const std::int32_t top = limit((v_d < 0 ? -v_d : v_d) >> 5);
    const auto v_q = static_cast<std::int32_t>(fixed::clip(in.v_q, -top, top));
    return {v_d, v_q, v_d != in.v_d || v_q != in.v_q};
  }

  // L(n) = floor(sqrt(2047^2 - min(2047, 32 (n + 1))^2))
  static constexpr std::int32_t limit(std::int32_t n) {
    const std::int32_t side = std::min(kRadius, 32 * (n + 1));
    const std::int32_t square = kRadius * kRadius - side * side;
    std::int32_t root = 0;
    for (std::int32_t bit = 1024; bit > 0; bit /= 2) {
      if ((root + bit) * (root + bit) <= square) root += bit;
    }
    return root;
  }

 private:
  static constexpr std::int32_t kRadius = 2047;
};

}  // namespace trammel::exact
