// SPDX-License-Identifier: Apache-2.0
//
// A bit-exact twin on its processor's bus, with the platform beside it. `Board`: a ProcessorBus.
// `Pins`: the table of the chip's ports, as of BusChip; the twin's In and out() have their names.
#pragma once

#include "cosim/hosted_twin.hpp"
#include "cosim/processor_bus.hpp"

namespace trammel::cosim {

template <class Base, class Board, class Pins, class Twin>
class BusTwin : public HostedTwin<Base, Board, Twin> {
 public:
  Lines drive() const override { return state_.lines; }
  void sense(Lines lines) override { Pins::sense(in_, lines); }
  void request(const BusOp& op) override {
    if (!state_.request(op)) put(state_.placed());
  }

 protected:
  using HostedTwin<Base, Board, Twin>::HostedTwin;
  using HostedTwin<Base, Board, Twin>::in_;
  using HostedTwin<Base, Board, Twin>::state_;
  using HostedTwin<Base, Board, Twin>::twin_;

  bool drive_changed() override { return state_.changed(Pins::drive(twin_.out())); }
  virtual void put(const BusOp& op) = 0;  // at the twin's bus

 private:
  bool publishes() const override { return state_.samples(state_.now); }
  bool bus_active() const final { return state_.platform_active || twin_.open(); }
  bool host_pin() const final { return twin_.irq(); }
  bool bus_edge(Clk edge) final {
    if (state_.platform_edge(edge, host_pin())) return true;
    if (twin_.open()) return false;
    state_.answer(twin_.read_data());
    return true;
  }
};

}  // namespace trammel::cosim
