// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/drive/lm628_output.sv.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class Lm628Output {
 public:
  struct Config {  // [clk]
    std::uint32_t strobe = 50;
    std::uint32_t period = 3200;
    std::uint32_t inc = 4;  // ticks per 25 clocks
  };

  struct In {
    bool commit = false;
    std::int32_t u = 0;  // 16 bits, signed
    bool eight_bits = true;
  };

  struct Out {
    std::uint8_t dac = 0x80;
    bool dac_hi_lo = true;
    bool dac_wr_n = true;
    bool pwm_mag = false;
    bool pwm_sign = false;
  };

  explicit Lm628Output(const Config& c) : c_(c) {}

  void reset() { *this = Lm628Output(c_); }

  Out out() const {
    const auto code = static_cast<std::uint32_t>(u_ + 0x8000);
    const bool low = state_ == State::kLowWrite || state_ == State::kLowHold;
    Out out;
    out.dac = static_cast<std::uint8_t>(low      ? code >> 2 & 0xFC
                                        : eight_ ? code >> 8
                                                 : code >> 8 & 0xFC);
    out.dac_hi_lo = !low;
    out.dac_wr_n = state_ != State::kLowWrite && state_ != State::kHighWrite;
    out.pwm_mag = high_.count() != 0;
    out.pwm_sign = u_ < 0;
    return out;
  }

  bool quiescent(const In& in) const {
    return !in.commit && period_.count() != 0 && (state_ == State::kIdle || strobe_.count() != 0);
  }

  Gap next(const In& in) const {
    if (!quiescent(in)) return 0;
    return std::min({strobe_.next({}), period_.next({}), high_.next({})});
  }

  void advance(Gap n) {
    strobe_.advance(n);
    period_.advance(n);
    high_.advance(n);
  }

  void step(const In& in) {
    if (in.commit) {
      u_ = in.u;
      eight_ = in.eight_bits;
    }
    const bool begins = in.commit || period_.count() == 0;
    period_.step({begins, c_.period - 1});
    high_.step({begins, high_time()});
    const bool last = strobe_.count() == 0;
    if (in.commit) {
      state_ = eight_ ? State::kIdle : State::kLowWrite;
    } else if (last) {
      state_ = after(state_);
    }
    strobe_.step({state_ != State::kIdle && (in.commit || last), c_.strobe - 1});
  }

 private:
  enum class State { kStart, kLowWrite, kLowHold, kHighWrite, kIdle };

  static State after(State s) {
    return s == State::kIdle ? State::kIdle : static_cast<State>(static_cast<int>(s) + 1);
  }

  // 4 m ticks, rounded down; |-128| acts as 127.
  std::uint32_t high_time() const {
    const auto m = static_cast<std::uint32_t>(std::min(std::abs(u_ >> 8), 127));
    return 100 * m / c_.inc;
  }

  Config c_;
  State state_ = State::kStart;
  Timer strobe_, period_, high_;
  std::int32_t u_ = 0;
  bool eight_ = false;
};

}  // namespace trammel::exact
