// SPDX-License-Identifier: Apache-2.0
//
// One serial converter as it hangs on the chip's pins (AD7476-style frame): it holds at the falling
// edge of chip select and shifts the 16 bits of its frame out, the next after each clock fall.
// It lives inside run(): its lines never cross to the plant, only the hold edge asks it.
#pragma once

#include <array>
#include <cstdint>

#include "machines/kung/chip/pins.hpp"

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

// Those of both axes, two each, on the pins of a chip.
class Converters {
 public:
  // After an edge: `code(channel)` samples the plant; true when one of the pins moved.
  template <class Model, class Code>
  bool serve(Model& m, Code&& code) {
    const unsigned cs = m.adc_cs_n_o, sclk = m.adc_sclk_o;
    if (cs == cs_n_ && sclk == sclk_) return false;
    for (int axis = 0; axis < kAxes; ++axis) {
      const unsigned bit = 1u << axis;
      if ((cs_n_ & ~cs & bit) != 0) {
        for (int phase = 0; phase < 2; ++phase) {
          adc_[axis][phase].hold(code(adc_channel(axis, phase)));
        }
      } else if ((sclk_ & ~sclk & bit) != 0) {
        for (auto& adc : adc_[axis]) adc.clock_fell();
      }
    }
    cs_n_ = cs;
    sclk_ = sclk;
    const bool a = put(m.adc_sdata_a_i, adc_[0][0].data() | (adc_[1][0].data() << 1));
    const bool b = put(m.adc_sdata_b_i, adc_[0][1].data() | (adc_[1][1].data() << 1));
    return a || b;
  }

 private:
  static bool put(std::uint8_t& pin, int value) {
    const bool moved = pin != value;
    pin = static_cast<std::uint8_t>(value);
    return moved;
  }

  std::array<std::array<SerialAdc, 2>, kAxes> adc_{};
  unsigned cs_n_ = 3, sclk_ = 3;
};

}  // namespace trammel::kung
