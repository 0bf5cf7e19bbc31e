// SPDX-License-Identifier: Apache-2.0
//
// Serial side of a converter of the MCP3008 type: 8 channels of 10 bits. After cs_n fell, a 1 at a
// rise of sclk is the start bit; single-ended or not and three bits of channel follow. It holds its
// input at the fall after the next rise, shows a 0 then, and each further fall brings a bit, the
// highest first.
#pragma once

#include <cstdint>

namespace trammel::plant {

class Mcp3008 {
 public:
  // Called with the pins after each clock in which one moved; `code(channel)` is called only at the
  // edge that holds. Returns dout.
  template <class Code>
  bool step(bool cs_n, bool sclk, bool din, Code&& code) {
    if (cs_n) {
      clocks_ = 0;
      word_ = 0;
    } else if (sclk && !sclk_) {
      if (clocks_ > 0 || din) ++clocks_;
      if (clocks_ <= kChannel) command_ = command_ * 2 % 8 + (din ? 1 : 0);
    } else if (!sclk && sclk_ && clocks_ >= kHold) {
      word_ = clocks_ == kHold ? static_cast<std::uint32_t>(code(command_)) : word_ * 2;
    }
    sclk_ = sclk;
    return (word_ >> kBits & 1) != 0;
  }

 private:
  static constexpr int kChannel = 5;  // clock of its last bit, the start bit is 1
  static constexpr int kHold = 6;
  static constexpr int kBits = 10;

  int clocks_ = 0;
  int command_ = 0;
  std::uint32_t word_ = 0;  // bit 10 is on the line
  bool sclk_ = false;
};

}  // namespace trammel::plant
