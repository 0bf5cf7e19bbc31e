// SPDX-License-Identifier: Apache-2.0
//
// One serial converter as it hangs on the chip's pins (AD7476-style frame): it holds at the falling
// edge of chip select and shifts the 16 bits of its frame out, the next after each clock fall.
// It lives inside run(): its lines never cross to the plant, only the hold edge asks it.
#pragma once

#include <cstdint>

namespace trammel::kung {

class SerialAdc {
 public:
  // Chip select fell: hold `frame`. Its first bit stands on the line at once.
  void hold(int frame) { frame_ = static_cast<std::uint32_t>(frame) & 0xffffu; bit_ = 15; }

  // The serial clock fell.
  void clock_fell() { if (bit_ > 0) --bit_; }

  bool data() const { return ((frame_ >> bit_) & 1u) != 0; }

 private:
  std::uint32_t frame_ = 0;
  int bit_ = 15;
};

}  // namespace trammel::kung
