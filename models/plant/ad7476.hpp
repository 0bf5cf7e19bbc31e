// SPDX-License-Identifier: Apache-2.0
//
// Serial side of an AD7476-style converter: it samples at the fall of cs_n and shows the first of
// four leading zeros; each fall of sclk brings the next bit, and 12 bits follow MSB first.
#pragma once

#include <cstdint>

namespace trammel::plant {

class Ad7476 {
 public:
  // Called with the pins after each clock; `code` is called only at the sampling edge.
  template <class Code>
  bool step(bool cs_n, bool sclk, Code&& code) {
    if (cs_n_ && !cs_n) {
      word_ = static_cast<std::uint32_t>(code()) % 4096;
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
