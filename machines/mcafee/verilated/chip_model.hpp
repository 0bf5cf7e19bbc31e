// SPDX-License-Identifier: Apache-2.0
//
// The verilated mcafee_xy behind the Chip interface; one template for all its models. Included only
// by the units of this folder.
#pragma once

#include "parts/lm628/verilated/words.hpp"
#include "machines/mcafee/chip.hpp"
#include "cosim/verilated/bus_chip.hpp"

namespace trammel::mcafee {

template <class Model, class Tracer>
class ChipModel : public cosim::BusChip<McafeeChip, cosim::ProcessorBus, Pins, Model, Tracer> {
  using OnBus = cosim::BusChip<McafeeChip, cosim::ProcessorBus, Pins, Model, Tracer>;
  using OnBus::model_;

 public:
  using OnBus::OnBus;

  std::vector<cosim::DomainActivity> activity() const override {
    return model_.activity(lm628::kDomains);
  }
  bool host_irq(int axis) const override { return (model_->hi_o >> axis & 1) != 0; }

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
};

}  // namespace trammel::mcafee
