// SPDX-License-Identifier: Apache-2.0
//
// Serial side of an AD7476-style converter: it samples at the fall of cs_n and shows the first bit
// of a frame of 16 then; each fall of sclk brings the next. Up to 12 bits stand behind four zeros,
// MSB first, with zeros behind them; 13 to 16 bits behind 3 to 0 (AD7476, AD7940 families).
#pragma once

#include <cstdint>

namespace trammel::plant {

// The frame of a code of that many bits, 6 to 16.
constexpr int serial_frame(int code, int bits) { return bits < 12 ? code << (12 - bits) : code; }

// Leading zeros in it.
constexpr int leading_zeros(int bits) { return bits <= 12 ? 4 : 16 - bits; }

class Ad7476 {
 public:
  // Called with the pins after each clock; `frame` is called only at the sampling edge.
  template <class Frame>
  bool step(bool cs_n, bool sclk, Frame&& frame) {
    if (cs_n_ && !cs_n) {
      word_ = static_cast<std::uint32_t>(frame()) % 65536;
    } else if (!cs_n && sclk_ && !sclk) {
      word_ = word_ * 2 % 65536;
    }
    cs_n_ = cs_n;
    sclk_ = sclk;
    return !cs_n && word_ / 32768 != 0;
  }

 private:
  std::uint32_t word_ = 0;  // bit 15 is on the line
  bool cs_n_ = true;
  bool sclk_ = true;
};

}  // namespace trammel::plant
