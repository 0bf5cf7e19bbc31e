// SPDX-License-Identifier: Apache-2.0
//
// Which pin of @name@_pwm is which word of the processor, and which is a line of the plant.
// Included only by the unit that the build makes of it.
#pragma once

#include <cstdint>

#include "cosim/verilated/pin_chip.hpp"
#include "machines/@name@/chip.hpp"
#include "machines/@name@/pins.hpp"
#include "models/pins/port.hpp"
#include "sw_nios/apps/@name@/@name@.hpp"

namespace trammel::@name@ {

struct Pins {
  static constexpr cosim::Clk kSampleClk = @name@::kSampleClk;
  static constexpr std::uint32_t kInputs = 2;

  template <class Model>
  static void write(Model& m, std::uint32_t number, std::uint32_t data) {
    if (number == sw::@name@_words::kEnable) m.enable = data & 1;
    if (number == sw::@name@_words::kDuty) m.duty = data & 0x1FFF;
  }

  template <class Model>
  static std::uint32_t read(const Model& m, std::uint32_t number) {
    if (number == sw::@name@_words::kEnable) return m.enable;
    const std::uint32_t word = number == sw::@name@_words::kDuty ? m.duty << 3 : m.count;
    const std::int32_t value = static_cast<std::int16_t>(static_cast<std::uint16_t>(word));
    return static_cast<std::uint32_t>(number == sw::@name@_words::kDuty ? value / 8 : value);
  }

  template <class Model>
  static void sense(Model& m, cosim::Lines lines) {
    m.enc_a = level(lines, kEncoderA);
    m.enc_b = level(lines, kEncoderB);
  }

  template <class Model>
  static cosim::Lines drive(const Model& m) {
    return cosim::Lines{m.pwm} << kPwm | cosim::Lines{m.direction} << kDirection;
  }
};

template <class Model, class Tracer>
using ChipModel = cosim::PinChip<Pins, Model, Tracer>;

}  // namespace trammel::@name@
