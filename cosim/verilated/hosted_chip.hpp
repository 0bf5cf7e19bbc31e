// SPDX-License-Identifier: Apache-2.0
//
// A hosted chip that is a verilated model.
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include "cosim/hosted.hpp"
#include "cosim/verilated/clocked_model.hpp"

namespace trammel::cosim {

template <class Base, class State, class Model, class Tracer>
class HostedChip : public Hosted<Base, State> {
 public:
  using Root = std::remove_pointer_t<decltype(Model::rootp)>;

  std::optional<FailedAssertion> failed_assertion() const override {
    return model_.failed_assertion();
  }
  Root& registers() { return model_.registers(state_.now); }
  void upset() { model_.upset(state_.now); }
  Tracer& tracer() { return model_.tracer(); }

 protected:
  using Hosted<Base, State>::state_;

  HostedChip(Tracer tracer, ModelMode mode) : model_(std::move(tracer), mode) {}

  // With all inputs set; its edges are those before 0.
  void reset() {
    auto& pin = reset_pin(*model_);
    pin = 1;
    for (state_.now = -4; state_.now < 0; ++state_.now) {
      model_.settle(state_.now, true);
      model_.raise(state_.now);
    }
    pin = 0;
    state_.dirty = true;
  }

  virtual void put_transfer() {}  // its inputs before an edge
  virtual void see_transfer() {}  // its outputs, settled, before the edge

  ClockedModel<Model, Tracer> model_;

 private:
  Clk settle(Clk edge, bool bus) final {
    if (bus) put_transfer();
    model_.settle(edge, state_.dirty || bus);
    if (bus) see_transfer();
    state_.dirty = false;
    return bus ? 1 : model_.waiting(edge);
  }
  void leap(Clk edge, Clk clocks) final {
    state_.evaluated += model_.leap(edge, clocks);
  }
  void raise(Clk edge) final {
    model_.raise(edge);
    ++state_.evaluated;
  }
};

}  // namespace trammel::cosim
