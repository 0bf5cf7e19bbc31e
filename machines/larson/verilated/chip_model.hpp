// SPDX-License-Identifier: Apache-2.0
//
// The verilated larson_xy behind the Chip interface; one template for all its models. Included
// only by the unit that the build makes of it.
#pragma once

#include <cstdint>
#include <utility>

#include "cosim/verilated/bus_chip.hpp"
#include "machines/larson/board.hpp"
#include "machines/larson/chip.hpp"

namespace trammel::larson {

template <class Model, class Tracer>
class ChipModel : public cosim::BusChip<LarsonChip, Board, Model, Tracer> {
  using OnBus = cosim::BusChip<LarsonChip, Board, Model, Tracer>;
  using OnBus::model_;
  using OnBus::state_;

 public:
  ChipModel(Tracer tracer, cosim::ModelMode mode, const ChipSetup& setup)
      : OnBus(std::move(tracer), mode) {
    static_cast<Board&>(state_) = Board(setup);
    sense(0);
    this->reset();
    state_.lines = pins();
  }

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

 private:
  void strobe() override { model_->s_axil_wstrb_i = static_cast<std::uint8_t>(state_.bytes()); }

  cosim::Lines pins() const {
    cosim::Lines lines = 0;
    for (int axis = 0; axis < kAxes; ++axis) {
      lines |= cosim::Lines{model_->step_o >> axis & 1u} << step(axis) |
               cosim::Lines{model_->forward_o >> axis & 1u} << forward(axis) |
               cosim::Lines{model_->flush_o >> axis & 1u} << flush(axis);
    }
    return lines;
  }

  bool drive_changed() override { return state_.changed(pins()); }
};

}  // namespace trammel::larson
