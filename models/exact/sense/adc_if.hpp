// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/sense/adc_if.sv. A frame is evaluated clock by clock.
#pragma once

#include <cstdint>

namespace trammel::exact {

class AdcIf {
 public:
  static constexpr int kFrame = 64;          // [clk] 16 periods of 4 clocks
  static constexpr int kLatency = kFrame + 1;  // [clk] from start to valid, both edges included

  struct In {
    bool start = false;
    bool sdata_a = false;
    bool sdata_b = false;
    int zeros = 4;  // leading zeros of a frame, taken with the start
  };

  struct Out {
    bool cs_n = true;
    bool sclk = true;
    bool busy = false;
    bool valid = false;
    std::uint16_t code_a = 0;
    std::uint16_t code_b = 0;
  };

  void reset() { *this = AdcIf(); }

  Out step(const In& in) {
    out_.valid = false;
    if (!out_.busy) {
      out_.busy = in.start;
      clock_ = 0;
      if (in.start) zeros_ = in.zeros;
    } else {
      const int part = clock_ % 4;
      out_.sclk = part == 0 || part == 3;
      if (part == 1 && clock_ / 4 < 12 + zeros_) {
        shift_a_ = shifted(shift_a_, in.sdata_a);
        shift_b_ = shifted(shift_b_, in.sdata_b);
      }
      if (++clock_ == kFrame) {
        out_.code_a = shift_a_;
        out_.code_b = shift_b_;
        out_.valid = true;
        out_.busy = false;
      }
    }
    out_.cs_n = !out_.busy;
    return out_;
  }

  const Out& out() const { return out_; }

  bool quiescent(const In& in) const { return !out_.busy && !in.start && !out_.valid; }

 private:
  static std::uint16_t shifted(std::uint16_t word, bool bit) {
    return static_cast<std::uint16_t>((word * 2 + (bit ? 1 : 0)) % 4096);
  }

  int clock_ = 0;  // since the fall of cs_n
  int zeros_ = 4;
  std::uint16_t shift_a_ = 0;
  std::uint16_t shift_b_ = 0;
  Out out_;
};

}  // namespace trammel::exact
