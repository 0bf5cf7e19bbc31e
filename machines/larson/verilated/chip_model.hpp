// SPDX-License-Identifier: Apache-2.0
//
// The verilated larson_xy behind the Chip interface; one template for all its models. Included
// only by the unit that the build makes of it.
#pragma once

#include <cstdint>
#include <utility>

#include "cosim/verilated/bus_chip.hpp"
#include "machines/larson/chip.hpp"
#include "machines/larson/surroundings.hpp"

namespace trammel::larson {

template <class Model, class Tracer>
class ChipModel : public cosim::BusChip<LarsonChip, Surroundings, Pins, Model, Tracer> {
  using OnBus = cosim::BusChip<LarsonChip, Surroundings, Pins, Model, Tracer>;
  using OnBus::model_;
  using OnBus::state_;

 public:
  using OnBus::OnBus;

  std::uint32_t words(int axis) const override {
    return axis == 0 ? model_->rootp->larson_xy__DOT__x : model_->rootp->larson_xy__DOT__y;
  }
  std::uint32_t err_byte() const override { return model_->rootp->larson_xy__DOT__err_byte; }
  unsigned requests() const override { return model_->rootp->larson_xy__DOT__u_table__DOT__irq; }

 private:
  void strobe() override { model_->s_axil_wstrb_i = static_cast<std::uint8_t>(state_.bytes()); }
};

}  // namespace trammel::larson
