// SPDX-License-Identifier: Apache-2.0
//
// PI controller of one current component (specification section 7).
// Twin of rtl/drive/current_pi.sv.
#pragma once

#include <cstdint>

#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class CurrentPi {
 public:
  struct In {
    bool clear = false;
    std::int32_t ref = 0, meas = 0;
    fixed::Gain kp{}, ki{};
  };
  struct Out {
    std::int32_t v = 0;
  };
  struct State {
    std::int64_t integral = 0;  // [v / 4096]
    std::int64_t error_prev = 0;
  };

  void reset() { state_ = {}; }

  Out step(const In& in) {
    if (in.clear) {
      reset();
      return {};
    }
    const std::int64_t e = fixed::sat(in.ref - 2 * std::int64_t{in.meas}, 12);  // Kung eq. 11
    // Kung eq. 13
    const std::int64_t step = fixed::rs(in.ki.mant * state_.error_prev, -1 - in.ki.exp);
    state_.integral = fixed::clip(state_.integral + step, -2048 * 4096, 2047 * 4096);
    state_.error_prev = e;
    const std::int64_t v_p = fixed::rs(in.kp.mant * e, 11 - in.kp.exp);  // Kung eq. 12
    const std::int64_t v_i = fixed::rs(state_.integral, 12);
    return {static_cast<std::int32_t>(fixed::sat(v_p + v_i, 12))};  // Kung eq. 14
  }

  const State& state() const { return state_; }

 private:
  State state_;
};

}  // namespace trammel::exact
