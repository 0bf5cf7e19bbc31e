// SPDX-License-Identifier: Apache-2.0
//
// A verilated chip beside the timer of its processor, behind the Chip interface `Base`. A leap
// passes neither `end` nor the timer, and none is made during a bus transfer, so that no pin moves
// inside it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "cosim/host_timer.hpp"
#include "cosim/verilated/clocked_model.hpp"

namespace trammel::cosim {

// What is kept beside a model. Together with the model's registers and inputs it is all that the
// next edges depend on, so that another model can go on from here; chips add their own to it.
struct HostedState {
  bool dirty = true;  // inputs changed since the last evaluation
  Clk now = -4;       // the first ones are the reset's
  Clk evaluated = 0;
  HostTimer timer;
  std::uint32_t rdata = 0;
  bool irq = false;
  bool host = false;  // the chip interrupts
  Clk host_rise = kNever;

  void count_as(const HostedState& other) { evaluated = other.evaluated; }
};

template <class Base, class State, class Model, class Tracer>
class HostedChip : public Base {
 public:
  using Root = std::remove_pointer_t<decltype(Model::rootp)>;

  Clk now() const override { return state_.now; }
  Clk evaluated() const override { return state_.evaluated; }
  bool irq() const override { return state_.irq; }
  std::uint32_t rdata() const override { return state_.rdata; }
  std::optional<BrokenPromise> broken_promise() const override { return model_.broken_promise(); }

  Clk host_rise() const override { return state_.host_rise; }

  Root& registers() { return *model_->rootp; }
  State& state() { return state_; }
  Tracer& tracer() { return model_.tracer(); }

  Stop run(Clk end, const Plant&) override {
    State& s = state_;
    while (s.now < end) {
      const Clk edge = s.now;
      const bool bus = bus_active();
      if (bus) put_transfer();
      model_.settle(edge, s.dirty || bus);
      if (bus) see_transfer();
      s.dirty = false;
      ++s.evaluated;
      const Clk clocks = bus ? 1 : std::min({model_.waiting(), end - edge, s.timer.waiting(edge)});
      if (clocks > 1) {
        model_.leap(edge, clocks);
        s.now += clocks;
        continue;
      }
      unsigned why = publishes() ? kSample : 0u;
      model_.raise(edge);
      ++s.now;
      if (bus && bus_edge(edge)) why |= kBusDone;
      s.timer.pass(edge);
      if (drive_changed()) why |= kDrive;
      const bool host = host_pin();
      if (host && !s.host) s.host_rise = edge;
      s.host = host;
      const bool irq = host || s.timer.irq();
      if (irq && !s.irq) why |= kIrq;
      s.irq = irq;
      if (why != 0) return {edge, why};
    }
    return {s.now - 1, kLimit};
  }

 protected:
  HostedChip(Tracer tracer, ModelMode mode) : model_(std::move(tracer), mode) {}

  // With all inputs set.
  void reset() {
    model_->rst_i = 1;
    for (; state_.now < 0; ++state_.now) {
      model_.settle(state_.now, true);
      model_.raise(state_.now);
    }
    model_->rst_i = 0;
    state_.dirty = true;
  }

  virtual bool bus_active() const = 0;
  virtual void put_transfer() {}           // its inputs before an edge
  virtual void see_transfer() {}           // its outputs, settled, before the edge
  virtual bool bus_edge(Clk edge) = 0;     // passes an edge of a transfer; true when it ended
  virtual bool publishes() const = 0;      // results of a sample, at the edge to come
  virtual bool drive_changed() = 0;        // by the edge just executed
  virtual bool host_pin() const = 0;       // the chip interrupts

  ClockedModel<Model, Tracer> model_;
  State state_;
};

}  // namespace trammel::cosim
