// SPDX-License-Identifier: Apache-2.0
//
// PI controller of one current component (specification section 7).
// Twin of rtl/drive/current_pi.sv: step() is one sample, run(0) to run(4) are its clocks, each with
// the inputs that the RTL reads at that clock.
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

  static constexpr int kClocks = 5;

  void reset() {
    state_ = {};
    out_ = {};
  }

  Out step(const In& in) {
    if (in.clear) reset();
    for (int clock = 0; clock < kClocks; ++clock) run(clock, in);
    return out_;
  }

  // While `clear` is high, every clock also does reset().
  void run(int clock, const In& in) {
    switch (clock) {
      case 0: error_ = fixed::sat(in.ref - 2 * std::int64_t{in.meas}, 12); break;  // Kung eq. 11
      case 1: multiply(in.ki, state_.error_prev); break;  // Kung eq. 13
      case 2:
        term_ = fixed::rs(product_, -1 - exponent(in.ki));
        multiply(in.kp, error_);  // Kung eq. 12
        break;
      case 3:
        state_.integral = fixed::clip(state_.integral + term_, -2048 * 4096, 2047 * 4096);
        term_ = fixed::rs(product_, 11 - exponent(in.kp));
        break;
      default:
        // Kung eq. 14
        out_.v = static_cast<std::int32_t>(
            fixed::sat(term_ + fixed::rs(state_.integral, 12), 12));
        state_.error_prev = error_;
        break;
    }
    if (in.clear && clock > 2) reset();
  }

  const Out& out() const { return out_; }
  const State& state() const { return state_; }

 private:
  // The mantissa and three bits of the exponent are read with the product, the rest a clock later.
  void multiply(const fixed::Gain& gain, std::int64_t x) {
    product_ = gain.mant * x;
    low_ = gain.exp & 7;
  }
  int exponent(const fixed::Gain& gain) const { return (gain.exp & ~7) | low_; }

  State state_;
  Out out_;
  std::int64_t error_ = 0, product_ = 0, term_ = 0;
  int low_ = 0;
};

}  // namespace trammel::exact
