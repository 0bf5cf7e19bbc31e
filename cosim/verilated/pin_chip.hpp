// SPDX-License-Identifier: Apache-2.0
//
// A verilated chip of any ports, whose pins a processor reads and writes as words. `Pins` says what
// they are, for every model of the chip:
//
//   static constexpr Clk kSampleClk;                          from one sample tick to the next
//   static constexpr std::uint32_t kInputs;                   input words 0 to kInputs - 1
//   static void write(Model&, std::uint32_t number, std::uint32_t data)
//   static std::uint32_t read(const Model&, std::uint32_t number)
//   static void sense(Model&, Lines)                          pins that the plant drives
//   static Lines drive(const Model&)                          pins that drive the plant
#pragma once

#include <cstdint>
#include <utility>

#include "cosim/pin_bus.hpp"
#include "cosim/verilated/hosted_chip.hpp"

namespace trammel::cosim {

template <class Pins, class Model, class Tracer>
class PinChip : public HostedChip<PinnedChip, PinBus, Model, Tracer> {
  using Hosted = HostedChip<PinnedChip, PinBus, Model, Tracer>;

 protected:
  using Hosted::model_;
  using Hosted::state_;

 public:
  PinChip(Tracer tracer, ModelMode mode) : Hosted(std::move(tracer), mode) {
    state_.ticks[0] = Pins::kSampleClk;
    for (std::uint32_t n = 0; n < Pins::kInputs; ++n) Pins::write(*model_, n, 0);
    sense(0);
    this->reset();
    state_.lines = Pins::drive(*model_);
  }

  Lines drive() const override { return state_.lines; }
  std::uint32_t word(std::uint32_t number) const override { return Pins::read(*model_, number); }

  void sense(Lines lines) override {
    Pins::sense(*model_, lines);
    state_.dirty = true;
  }

  void request(const BusOp& op) override { state_.pins_active = !state_.request(op); }

 private:
  bool bus_active() const override { return state_.pins_active || state_.platform_active; }
  bool publishes() const override { return state_.samples(state_.now); }
  bool host_pin() const override { return false; }

  // The transfer ends at its first edge; what it wrote is at the pins from the next one on.
  bool bus_edge(Clk edge) override {
    if (state_.platform_edge(edge, false)) return true;
    const BusOp& op = state_.op;
    state_.pins_active = false;
    if (op.write) {
      Pins::write(*model_, op.addr / 4, op.data);
      state_.dirty = true;
    } else {
      state_.rdata = word(op.addr / 4);
    }
    return true;
  }

  bool drive_changed() override { return state_.changed(Pins::drive(*model_)); }
};

}  // namespace trammel::cosim
