// SPDX-License-Identifier: Apache-2.0
//
// The verilated mcafee_xy behind the Chip interface; one template for all its models. Included only
// by the units of this folder.
#pragma once

#include "parts/lm628/verilated/words.hpp"
#include "machines/mcafee/board.hpp"
#include "machines/mcafee/chip.hpp"
#include "cosim/verilated/bus_chip.hpp"

namespace trammel::mcafee {

template <class Model, class Tracer>
class ChipModel : public cosim::BusChip<McafeeChip, Board, Model, Tracer> {
  using OnBus = cosim::BusChip<McafeeChip, Board, Model, Tracer>;
  using OnBus::model_;
  using OnBus::state_;

 public:
  ChipModel(Tracer tracer, cosim::ModelMode mode) : OnBus(std::move(tracer), mode) {
    sense(0);
    this->reset();
    drive_changed();
  }

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
  bool publishes() const override { return (model_->sample_o & 1) != 0; }

  bool drive_changed() override { return state_.convert(model_->dac_x_o, model_->dac_y_o); }
};

}  // namespace trammel::mcafee
