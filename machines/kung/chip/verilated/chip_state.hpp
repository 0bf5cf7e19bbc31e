// SPDX-License-Identifier: Apache-2.0
//
// What a verilated chip keeps beside its model: where it stands, the converters on its pins, and
// what it put out last. Together with the registers and inputs of the model it is all that the next
// edges depend on, so that another model can go on from here.
#pragma once

#include <array>

#include "cosim/cosim.hpp"
#include "machines/kung/chip/lines.hpp"
#include "machines/kung/chip/verilated/adc.hpp"
#include "machines/kung/chip/wakes.hpp"
#include "cosim/verilated/axi_lite.hpp"

namespace trammel::kung {

struct ChipState {
  static constexpr int kResetEdges = 4;

  bool dirty_ = true;  // inputs changed since the last evaluation
  cosim::Clk now_ = -kResetEdges;
  cosim::Clk evaluated_ = 0;
  WakeCounts wakes_{};
  cosim::Clk sensed_ = 0;  // edge of the last change of a pin
  bool position_ = false;  // the position controller computes
  std::array<std::array<SerialAdc, 2>, kAxes> adc_{};
  unsigned cs_n_ = 3, sclk_ = 3;
  unsigned hi_ = 0, lo_ = 0;
  bool irq_ = false, tick_ = false;
  cosim::AxiLiteMaster bus_;

  // Clocks are evaluated as often as by another chip.
  void count_as(const ChipState& other) {
    evaluated_ = other.evaluated_;
    wakes_ = other.wakes_;
  }
};

}  // namespace trammel::kung
