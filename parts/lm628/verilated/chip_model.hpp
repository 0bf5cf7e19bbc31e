// SPDX-License-Identifier: Apache-2.0
//
// The verilated LM628 behind the Chip interface; one template for all its models. Included only by
// the units of this folder.
#pragma once

#include "parts/lm628/surroundings.hpp"
#include "parts/lm628/chip.hpp"
#include "parts/lm628/verilated/words.hpp"
#include "cosim/verilated/hosted_chip.hpp"

namespace trammel::lm628 {

template <class Model, class Tracer>
class ChipModel : public cosim::HostedChip<Lm628Chip, Surroundings, Model, Tracer> {
  using Hosted = cosim::HostedChip<Lm628Chip, Surroundings, Model, Tracer>;
  using Hosted::model_;
  using Hosted::state_;

 public:
  ChipModel(Tracer tracer, cosim::ModelMode mode, const PartOptions& part)
      : Hosted(std::move(tracer), mode) {
    state_ = Surroundings(part);
    model_->wrap_i = part.wrap;
    sense(0);
    put_transfer();
    this->reset();
  }

  cosim::Lines drive() const override { return state_.lines; }
  bool host_irq() const override { return host_pin(); }
  std::vector<cosim::DomainActivity> activity() const override { return model_.activity(kDomains); }

  void sense(cosim::Lines lines) override {
    model_->enc_a_i = level(lines, kEncoderA);
    model_->enc_b_i = level(lines, kEncoderB);
    model_->enc_idx_n_i = !level(lines, kIndex);
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
    if (!state_.bus_edge(edge, model_->d_o, host_pin())) return false;
    put_transfer();
    state_.dirty = true;
    return true;
  }

  bool drive_changed() override {
    return state_.output({model_->dac_o, model_->dac_hi_lo_o != 0, model_->dac_wr_n_o != 0,
                          model_->pwm_mag_o != 0, model_->pwm_sign_o != 0});
  }
};

}  // namespace trammel::lm628
