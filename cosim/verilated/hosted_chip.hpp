// SPDX-License-Identifier: Apache-2.0
//
// A verilated chip beside the timer of its processor, behind the Chip interface `Base`. A leap
// passes neither `end` nor the timer, and none is made during a bus transfer, so that no pin moves
// inside it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "cosim/host_timer.hpp"
#include "cosim/verilated/clocked_model.hpp"

namespace trammel::cosim {

template <class Base, class Model>
class HostedChip : public Base {
 public:
  Clk now() const override { return now_; }
  Clk evaluated() const override { return evaluated_; }
  bool irq() const override { return irq_; }
  std::uint32_t rdata() const override { return rdata_; }

  Stop run(Clk end, const Plant&) override {
    while (now_ < end) {
      const Clk edge = now_;
      const bool bus = bus_active();
      settle(bus);
      dirty_ = false;
      ++evaluated_;
      const Clk clocks =
          bus ? 1 : std::min({model_.waiting(), end - edge, timer_.waiting(edge)});
      if (clocks > 1) {
        model_.leap(clocks);
        now_ += clocks;
        continue;
      }
      unsigned why = publishes() ? kSample : 0u;
      model_.raise();
      ++now_;
      if (bus && bus_edge(edge)) why |= kBusDone;
      timer_.pass(edge);
      if (drive_changed()) why |= kDrive;
      const bool irq = host_pin() || timer_.irq();
      if (irq && !irq_) why |= kIrq;
      irq_ = irq;
      if (why != 0) return {edge, why};
    }
    return {now_ - 1, kLimit};
  }

 protected:
  explicit HostedChip(bool leap) : model_(leap) {}

  // With all inputs set.
  void reset() {
    model_->rst_i = 1;
    for (; now_ < 0; ++now_) {
      model_->eval();
      model_.raise();
    }
    model_->rst_i = 0;
    dirty_ = true;
  }

  virtual bool bus_active() const = 0;
  virtual void settle(bool bus) = 0;       // inputs reach the logic before an edge
  virtual bool bus_edge(Clk edge) = 0;     // passes an edge of a transfer; true when it ended
  virtual bool publishes() const = 0;      // results of a sample, at the edge to come
  virtual bool drive_changed() = 0;        // by the edge just executed
  virtual bool host_pin() const = 0;       // the chip interrupts

  ClockedModel<Model> model_;
  HostTimer timer_;
  bool dirty_ = true;  // inputs changed since the last evaluation
  std::uint32_t rdata_ = 0;

 private:
  static constexpr Clk kResetEdges = 4;

  Clk now_ = -kResetEdges;
  Clk evaluated_ = 0;
  bool irq_ = false;
};

}  // namespace trammel::cosim
