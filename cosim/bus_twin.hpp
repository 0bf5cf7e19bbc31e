// SPDX-License-Identifier: Apache-2.0
//
// A bit-exact twin on its processor's bus, with the platform beside it. `Surroundings`: a
// ProcessorBus. `Pins`: the table of the chip's ports, as of BusChip; the twin's In and out()
// have their names.
// Its reset is behind it when it is made.
#pragma once

#include "cosim/hosted_twin.hpp"
#include "cosim/processor_bus.hpp"

namespace trammel::cosim {

template <class Base, class Surroundings, class Pins, class Twin>
class BusTwin : public HostedTwin<Base, Surroundings, Twin> {
 public:
  explicit BusTwin(const Twin& twin, const Surroundings& board = Surroundings())
      : HostedTwin<Base, Surroundings, Twin>(twin) {
    state_ = board;
    state_.connect(in_);
    this->reset();
    show();
  }

  Lines drive() const override { return state_.lines; }
  void sense(Lines lines) override { Pins::sense(in_, lines); }
  void request(const BusOp& op) override {
    if (!state_.request(op)) put(state_.placed());
  }

 protected:
  using HostedTwin<Base, Surroundings, Twin>::in_;
  using HostedTwin<Base, Surroundings, Twin>::state_;
  using HostedTwin<Base, Surroundings, Twin>::twin_;

  // At the twin's bus.
  virtual void put(const BusOp& op) { twin_.request(op.addr, op.data, op.write); }

 private:
  bool show() { return state_.changed(Pins::drive(twin_.out())); }
  bool drive_changed() final {
    state_.serve(twin_.out(), in_, [this](int channel) { return this->sampled(channel); });
    return show();
  }
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
