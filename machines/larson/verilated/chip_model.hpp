// SPDX-License-Identifier: Apache-2.0
//
// The verilated larson_xy behind the Chip interface; one template for all its models. Included
// only by the unit that the build makes of it.
#pragma once

#include <cstdint>
#include <utility>

#include "cosim/verilated/axi_lite.hpp"
#include "cosim/verilated/hosted_chip.hpp"
#include "machines/larson/board.hpp"
#include "machines/larson/chip.hpp"

namespace trammel::larson {

struct ChipState : Board {
  cosim::AxiLiteMaster bus;
};

template <class Model, class Tracer>
class ChipModel : public cosim::HostedChip<LarsonChip, ChipState, Model, Tracer> {
  using Hosted = cosim::HostedChip<LarsonChip, ChipState, Model, Tracer>;
  using Hosted::model_;
  using Hosted::state_;

 public:
  ChipModel(Tracer tracer, cosim::ModelMode mode, const ChipSetup& setup)
      : Hosted(std::move(tracer), mode) {
    state_.sample_clk = setup.sample_clk;
    state_.bus.reset(*model_);
    sense(0);
    this->reset();
    state_.lines = pins();
  }

  cosim::Lines drive() const override { return state_.lines; }
  std::uint32_t words(int axis) const override {
    return axis == 0 ? model_->rootp->larson_xy__DOT__x : model_->rootp->larson_xy__DOT__y;
  }
  std::uint32_t err_byte() const override { return model_->rootp->larson_xy__DOT__err_byte; }
  unsigned requests() const override { return model_->rootp->larson_xy__DOT__u_table__DOT__irq; }

  void sense(cosim::Lines lines) override {
    const auto pair = [lines](int x, int y) {
      return static_cast<std::uint8_t>((lines >> x & 1u) | (lines >> y & 1u) << 1);
    };
    model_->limit_low_i = pair(limit_low(0), limit_low(1));
    model_->limit_high_i = pair(limit_high(0), limit_high(1));
    model_->buf_busy_i = pair(buf_busy(0), buf_busy(1));
    state_.dirty = true;
  }

  void request(const cosim::BusOp& op) override {
    if (state_.request(op)) return;
    state_.bus.request(*model_, state_.placed());
    model_->s_axil_wstrb_i = static_cast<std::uint8_t>(state_.bytes());
  }

 private:
  cosim::Lines pins() const {
    cosim::Lines lines = 0;
    for (int axis = 0; axis < kAxes; ++axis) {
      lines |= cosim::Lines{model_->step_o >> axis & 1u} << step(axis) |
               cosim::Lines{model_->forward_o >> axis & 1u} << forward(axis) |
               cosim::Lines{model_->flush_o >> axis & 1u} << flush(axis);
    }
    return lines;
  }

  bool bus_active() const override { return state_.bus.active() || state_.platform_active; }
  void see_transfer() override {
    if (state_.bus.active()) state_.bus.before_edge(*model_);
  }
  bool publishes() const override { return state_.samples(state_.now); }
  bool host_pin() const override { return model_->irq_o != 0; }

  bool bus_edge(cosim::Clk edge) override {
    if (state_.platform_active) {
      state_.platform_edge(edge, host_pin());
      return true;
    }
    state_.dirty = true;
    if (!state_.bus.after_edge(*model_)) return false;
    state_.answer(state_.bus.rdata());
    return true;
  }

  bool drive_changed() override { return state_.changed(pins()); }
};

}  // namespace trammel::larson
