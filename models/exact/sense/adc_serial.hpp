// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/sense/adc_serial.sv.
#pragma once

#include <cstdint>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class AdcSerial {
 public:
  struct In {
    bool start = false;
    std::uint32_t channel = 0;
    bool dout = false;
  };
  struct Out {
    bool cs_n = true, sclk = false, din = false;
    bool valid = false;
    std::uint32_t channel = 0, code = 0;
  };

  explicit AdcSerial(std::uint32_t half = 8) : half_(half) {}

  void reset() { *this = AdcSerial(half_); }

  Out out() const { return {left_ == 0, sclk_, left_ != 0 && din_ >= 16, valid_, channel_, code_}; }

  void step(const In& in) {
    valid_ = false;
    if (left_ == 0) {
      if (!in.start) return;
      left_ = kEdges;
      din_ = 24 + in.channel;
      channel_ = in.channel;
      timer_.step({true, half_});
      return;
    }
    if (timer_.count() != 1) {
      timer_.step({});
      return;
    }
    if (sclk_) {
      din_ = din_ * 2 % 32;
    } else {
      code_ = (code_ * 2 + (in.dout ? 1 : 0)) % 1024;
    }
    sclk_ = !sclk_;
    valid_ = --left_ == 0;
    timer_.step({left_ != 0, half_});
  }

  bool quiescent(const In& in) const {
    return !valid_ && (left_ == 0 ? !in.start : timer_.count() != 1);
  }
  Gap next() const { return timer_.next({}); }
  void advance(Gap n) { timer_.advance(n); }

 private:
  static constexpr int kEdges = 34;  // of sclk

  std::uint32_t half_;
  Timer timer_;
  int left_ = 0;
  std::uint32_t din_ = 0, channel_ = 0, code_ = 0;
  bool sclk_ = false, valid_ = false;
};

}  // namespace trammel::exact
