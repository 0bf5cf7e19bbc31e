// SPDX-License-Identifier: Apache-2.0
//
// What a verilated chip keeps beside its model: where it stands, the converters on its pins, and
// what it put out last. Together with the registers and inputs of the model it is all that the next
// edges depend on, so that another model can go on from here.
#pragma once

#include "cosim/cosim.hpp"
#include "machines/kung/chip/pins.hpp"
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
  Converters converters_;
  unsigned hi_ = 0, lo_ = 0;
  bool irq_ = false, tick_ = false;
  cosim::AxiLiteMaster bus_;

  static constexpr cosim::Clk kEncoderSettles = 12;  // synchroniser, usual filters, decoder

  // Of the next edge, before it; busy(axis): its current loop computes.
  template <class Model, class Busy>
  Wake wake(const Model& m, cosim::Clk edge, cosim::Clk clocks, Busy&& busy) {
    if (m.tick_o) position_ = true;
    if (m.sample_o) position_ = false;
    if (clocks > 1) return Wake::kLeap;
    if (bus_.active()) return Wake::kBus;
    if (m.tick_o) return Wake::kTick;
    if (m.adc_cs_n_o != 3) return Wake::kConverter;
    if (busy(0) || busy(1)) return Wake::kCurrent;
    if (position_) return Wake::kPosition;
    return edge - sensed_ < kEncoderSettles ? Wake::kEncoder : Wake::kGate;
  }

  // Why a run stops after an edge.
  template <class Model>
  unsigned changed_outputs(const Model& m) {
    unsigned why = 0;
    if (m.gate_hi_o != hi_ || m.gate_lo_o != lo_) why |= cosim::kDrive;
    if (m.irq_o && !irq_) why |= cosim::kIrq;
    if (tick_) why |= cosim::kTick;  // tick_o is high before the edge that acts on it
    if (m.sample_o) why |= cosim::kSample;
    remember_outputs(m);
    return why;
  }
  template <class Model>
  void remember_outputs(const Model& m) {
    hi_ = m.gate_hi_o;
    lo_ = m.gate_lo_o;
    irq_ = m.irq_o;
    tick_ = m.tick_o;
  }

  // Clocks are evaluated as often as by another chip.
  void count_as(const ChipState& other) {
    evaluated_ = other.evaluated_;
    wakes_ = other.wakes_;
  }
};

}  // namespace trammel::kung
