// SPDX-License-Identifier: Apache-2.0
//
// A chip and its processor's timer behind the Chip interface `Base`, for models and twins alike.
// A leap passes neither the end of a look-ahead nor the timer, and none is made during a bus
// transfer, so that no pin moves inside it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "cosim/cosim.hpp"
#include "cosim/host_timer.hpp"

namespace trammel::cosim {

// State kept beside the evaluated chip, to which chips add theirs. With the registers and inputs of
// a model it determines the next edges, so that another model can continue from it.
struct HostedState {
  bool dirty = true;  // inputs changed since the last evaluation
  Clk now = 0;
  Clk evaluated = 0;
  HostTimer timer;
  std::uint32_t rdata = 0;
  bool irq = false;
  bool host = false;  // the chip interrupts
  Clk host_rise = kNever;

  // Edges from `edge` on in which nothing beside the chip happens: at least 1.
  Clk waiting(Clk edge) const { return timer.waiting(edge); }

  void count_as(const HostedState& other) { evaluated = other.evaluated; }
};

template <class Base, class State>
class Hosted : public Base {
 public:
  Clk now() const override { return state_.now; }
  Clk evaluated() const override { return state_.evaluated; }
  bool irq() const override { return state_.irq; }
  std::uint32_t rdata() const override { return state_.rdata; }
  Clk host_rise() const override { return state_.host_rise; }

  State& state() { return state_; }

  Stop run(Clk end, const Plant& plant) override {
    State& s = state_;
    plant_ = &plant;
    while (s.now < end) {
      const Clk edge = s.now;
      const bool bus = bus_active();
      const Clk clocks = std::min({settle(edge, bus), end - edge, s.waiting(edge)});
      if (clocks > 1) {
        leap(edge, clocks);
        s.now += clocks;
        continue;
      }
      unsigned why = publishes() ? kSample : 0u;
      raise(edge);
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
  virtual bool bus_active() const = 0;
  // Before an edge: how many edges from it on only count; at most 1 during a bus transfer.
  virtual Clk settle(Clk edge, bool bus) = 0;
  virtual void leap(Clk edge, Clk clocks) = 0;    // passes that many at once
  virtual void raise(Clk edge) = 0;               // passes one
  virtual bool bus_edge(Clk edge) = 0;            // of a transfer was passed; true when it ended
  virtual bool publishes() const = 0;             // results of a sample, at the edge to come
  virtual bool drive_changed() = 0;               // by the edge just passed
  virtual bool host_pin() const = 0;              // the chip interrupts

  // What a converter takes at the edge just passed.
  int sampled(int channel) const { return plant_->sample(channel, state_.now - 1); }

  State state_;

 private:
  const Plant* plant_ = nullptr;  // of this run
};

}  // namespace trammel::cosim
