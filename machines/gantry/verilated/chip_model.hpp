// SPDX-License-Identifier: Apache-2.0
//
// The verilated gantry_tau behind the Chip interface; one template for all its models. Included
// only by the unit that the build makes of it.
#pragma once

#include "cosim/verilated/bus_chip.hpp"
#include "machines/gantry/surroundings.hpp"
#include "machines/gantry/verilated/words.hpp"

namespace trammel::gantry {

template <class Model, class Tracer>
class ChipModel : public cosim::BusChip<GantryChip, Surroundings, Pins, Model, Tracer> {
  using OnBus = cosim::BusChip<GantryChip, Surroundings, Pins, Model, Tracer>;
  using OnBus::model_;
  using OnBus::state_;

 public:
  using OnBus::OnBus;

  const Store& store() const override { return state_.store; }
  Words words() const override { return words_of(*model_->rootp); }
};

}  // namespace trammel::gantry
