// SPDX-License-Identifier: Apache-2.0
//
// Clarke transform of two measured phase currents. Twin of rtl/drive/clarke.sv.
#pragma once

#include <cstdint>

#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class Clarke {
 public:
  struct In {
    std::int32_t i_a = 0, i_b = 0;
  };
  struct Out {
    std::int32_t i_alpha = 0, i_beta = 0;
  };

  void reset() {}

  Out step(const In& in) const {
    constexpr std::int64_t kInvSqrt3 = 1182;  // Q11
    // Kung eq. 7
    const std::int64_t sum = std::int64_t{in.i_a} + 2 * std::int64_t{in.i_b};
    return {in.i_a, static_cast<std::int32_t>(fixed::sat(fixed::rs(kInvSqrt3 * sum, 11), 12))};
  }
};

}  // namespace trammel::exact
