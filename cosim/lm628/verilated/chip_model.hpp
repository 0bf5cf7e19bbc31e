// SPDX-License-Identifier: Apache-2.0
//
// The verilated LM628 behind the Chip interface; one template for all its models. Included only by
// the units of this folder.
#pragma once

#include "cosim/lm628/chip.hpp"
#include "cosim/lm628/host_port.hpp"
#include "cosim/lm628/verilated/words.hpp"
#include "cosim/verilated/hosted_chip.hpp"

namespace trammel::lm628 {

struct ChipState : cosim::HostedState {
  HostPort port;
  bool dac_wr_n = true;
  unsigned low_six = 0;
  unsigned code = static_cast<unsigned>(kZeroCode);
};

template <class Model, class Tracer>
class ChipModel : public cosim::HostedChip<Lm628Chip, ChipState, Model, Tracer> {
  using Hosted = cosim::HostedChip<Lm628Chip, ChipState, Model, Tracer>;
  using Hosted::model_;
  using Hosted::state_;

 public:
  ChipModel(Tracer tracer, cosim::ModelMode mode) : Hosted(std::move(tracer), mode) {
    model_->wrap_i = 0;
    sense(0);
    put_transfer();
    this->reset();
  }

  cosim::Lines drive() const override { return state_.code; }
  bool host_irq() const override { return host_pin(); }

  void sense(cosim::Lines lines) override {
    model_->enc_a_i = lines >> kEncoderA & 1u;
    model_->enc_b_i = lines >> kEncoderB & 1u;
    model_->enc_idx_n_i = (lines >> kIndex & 1u) == 0;
    state_.dirty = true;
  }

  void request(const cosim::BusOp& op) override { state_.port.request(op); }

  Words words() const override {
    const auto& root = *model_->rootp;
    return words_of(root.lm628__DOT__u_engine__DOT__m_q, root.lm628__DOT__u_engine__DOT__u_q,
                    root.lm628__DOT__u_port__DOT__status);
  }

 private:
  bool bus_active() const override { return state_.port.active(); }
  bool publishes() const override { return model_->sample_o != 0; }
  bool host_pin() const override { return model_->hi_o != 0; }

  void put_transfer() override {
    const HostPins pins = state_.port.pins();
    model_->cs_n_i = pins.cs_n;
    model_->rd_n_i = pins.rd_n;
    model_->wr_n_i = pins.wr_n;
    model_->ps_i = pins.ps;
    model_->d_i = pins.d;
    model_->reset_n_i = pins.reset_n;
  }

  bool bus_edge(cosim::Clk edge) override {
    namespace map = sw::lm628_map;
    if (state_.port.takes_data()) state_.rdata = model_->d_o;
    if (!state_.port.advance()) return false;
    const cosim::BusOp& op = state_.port.op();
    if (op.addr == map::kTimer && op.write) {
      state_.timer.write(edge, op.data);
    } else if (op.addr == map::kIrq && !op.write) {
      state_.rdata = (host_pin() ? map::kIrqHost : 0u) | (state_.timer.irq() ? map::kIrqTimer : 0u);
    }
    put_transfer();
    state_.dirty = true;
    return true;
  }

  bool drive_changed() override {
    ChipState& s = state_;
    const bool strobe = model_->dac_wr_n_o && !s.dac_wr_n;
    s.dac_wr_n = model_->dac_wr_n_o != 0;
    const unsigned six = model_->dac_o >> 2;
    if (strobe && !model_->dac_hi_lo_o) s.low_six = six;
    if (!strobe || !model_->dac_hi_lo_o || (six << 6 | s.low_six) == s.code) return false;
    s.code = six << 6 | s.low_six;
    return true;
  }
};

}  // namespace trammel::lm628
