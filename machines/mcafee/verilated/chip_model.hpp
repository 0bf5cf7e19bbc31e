// SPDX-License-Identifier: Apache-2.0
//
// The verilated mcafee_xy behind the Chip interface; one template for all its models. Included only
// by the units of this folder.
#pragma once

#include "parts/lm628/verilated/words.hpp"
#include "machines/mcafee/board.hpp"
#include "machines/mcafee/chip.hpp"
#include "cosim/verilated/axi_lite.hpp"
#include "cosim/verilated/hosted_chip.hpp"

namespace trammel::mcafee {

struct ChipState : Board {
  cosim::AxiLiteMaster bus;
};

template <class Model, class Tracer>
class ChipModel : public cosim::HostedChip<McafeeChip, ChipState, Model, Tracer> {
  using Hosted = cosim::HostedChip<McafeeChip, ChipState, Model, Tracer>;
  using Hosted::model_;
  using Hosted::state_;

 public:
  ChipModel(Tracer tracer, cosim::ModelMode mode) : Hosted(std::move(tracer), mode) {
    state_.bus.reset(*model_);
    sense(0);
    this->reset();
    drive_changed();
  }

  cosim::Lines drive() const override { return state_.codes; }
  std::vector<cosim::DomainActivity> activity() const override {
    return model_.activity(lm628::kDomains);
  }
  bool host_irq(int axis) const override { return (model_->hi_o >> axis & 1) != 0; }

  void sense(cosim::Lines lines) override {
    const auto pick = [lines](int x, int y) {
      return static_cast<std::uint8_t>((lines >> x & 1u) | (lines >> y & 1u) << 1);
    };
    model_->enc_a_i = pick(encoder_a(0), encoder_a(1));
    model_->enc_b_i = pick(encoder_b(0), encoder_b(1));
    model_->enc_idx_n_i = static_cast<std::uint8_t>(~pick(marker(0), marker(1)) & 3u);
    model_->limit_i = static_cast<std::uint8_t>(pick(limit_low(0), limit_high(0)) |
                                                pick(limit_low(1), limit_high(1)) << 2);
    state_.dirty = true;
  }

  void request(const cosim::BusOp& op) override {
    if (!state_.request(op)) state_.bus.request(*model_, op);
  }

  lm628::Words words(int axis) const override {
    const auto& root = *model_->rootp;
    if (axis == 0) {
      return lm628::words_of(root.mcafee_xy__DOT__u_x__DOT__u_engine__DOT__m_q,
                             root.mcafee_xy__DOT__u_x__DOT__u_engine__DOT__u_q,
                             root.mcafee_xy__DOT__u_x__DOT__u_port__DOT__status);
    }
    return lm628::words_of(root.mcafee_xy__DOT__u_y__DOT__u_engine__DOT__m_q,
                           root.mcafee_xy__DOT__u_y__DOT__u_engine__DOT__u_q,
                           root.mcafee_xy__DOT__u_y__DOT__u_port__DOT__status);
  }

 private:
  bool bus_active() const override { return state_.bus.active() || state_.platform_active; }
  void see_transfer() override {
    if (state_.bus.active()) state_.bus.before_edge(*model_);
  }
  bool publishes() const override { return (model_->sample_o & 1) != 0; }
  bool host_pin() const override { return model_->irq_o != 0; }

  bool bus_edge(cosim::Clk edge) override {
    if (state_.platform_active) {
      state_.platform_edge(edge, host_pin());
      return true;
    }
    state_.dirty = true;
    if (!state_.bus.after_edge(*model_)) return false;
    state_.rdata = state_.bus.rdata();
    return true;
  }

  bool drive_changed() override { return state_.convert(model_->dac_x_o, model_->dac_y_o); }
};

}  // namespace trammel::mcafee
