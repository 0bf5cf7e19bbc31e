// SPDX-License-Identifier: Apache-2.0
//
// A verilated chip with an AXI4-Lite port and an interrupt, `irq_o`, and the platform beside it.
// `Surroundings`: a ProcessorBus, made of a chip's `Setup`. Its reset is behind it when it is made.
// `Pins`: the table of the chip's ports,
//
//   static constexpr Lines kIdle          that the plant drives at the reset
//   static void sense(Model&, Lines)      that the plant drives
//   static Lines drive(const Model&)      that drive the plant
#pragma once

#include <utility>

#include "cosim/processor_bus.hpp"
#include "cosim/verilated/axi_lite.hpp"
#include "cosim/verilated/hosted_chip.hpp"

namespace trammel::cosim {

template <class Surroundings>
struct BusState : Surroundings {
  using Surroundings::Surroundings;
  AxiLiteMaster bus;
};

template <class Base, class Surroundings, class Pins, class Model, class Tracer>
class BusChip : public HostedChip<Base, BusState<Surroundings>, Model, Tracer> {
  using Hosted = HostedChip<Base, BusState<Surroundings>, Model, Tracer>;

 public:
  template <class... Setup>
  BusChip(Tracer tracer, ModelMode mode, const Setup&... setup) : Hosted(std::move(tracer), mode) {
    static_cast<Surroundings&>(state_) = Surroundings(setup...);
    state_.bus.reset(*model_);
    state_.connect(*model_);
    BusChip::sense(Pins::kIdle);
    this->reset();
    show();
  }

  Lines drive() const override { return state_.lines; }
  void sense(Lines lines) override {
    Pins::sense(*model_, lines);
    state_.dirty = true;
  }
  void request(const BusOp& op) override {
    if (state_.request(op)) return;
    state_.bus.request(*model_, state_.placed());
    strobe();
  }

 protected:
  using Hosted::model_;
  using Hosted::state_;

  virtual void strobe() {}  // other bytes of a transfer than all

 private:
  bool show() { return state_.changed(Pins::drive(*model_)); }
  bool drive_changed() final {
    const auto code = [this](int channel) { return this->sampled(channel); };
    if (state_.serve(*model_, *model_, code)) state_.dirty = true;
    return show();
  }
  bool publishes() const override { return state_.samples(state_.now); }
  bool bus_active() const final { return state_.bus.active() || state_.platform_active; }
  bool host_pin() const final { return model_->irq_o != 0; }
  void see_transfer() final {
    if (state_.bus.active()) state_.bus.before_edge(*model_);
  }
  bool bus_edge(Clk edge) final {
    if (state_.platform_edge(edge, host_pin())) return true;
    state_.dirty = true;
    if (!state_.bus.after_edge(*model_)) return false;
    state_.answer(state_.bus.rdata());
    return true;
  }
};

}  // namespace trammel::cosim
