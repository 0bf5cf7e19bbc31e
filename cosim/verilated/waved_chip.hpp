// SPDX-License-Identifier: Apache-2.0
//
// A run with waves is simulated by a chip without them; in its windows alone a slower, traced chip
// runs the same edges after it.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "cosim/verilated/in_step.hpp"
#include "cosim/waves.hpp"

namespace trammel::cosim {

template <class First, class Traced, class Registers>
class WavedChip final : public InStep<First, Traced, Registers> {
  using Base = InStep<First, Traced, Registers>;
  using Base::second_;

 public:
  template <class Tracer, class... Setup>
  WavedChip(ModelMode mode, Tracer tracer, const WaveWindow& window, const Setup&... setup)
      : Base({"waves_are_exact", "in the run", "in its waves"}, mode, std::move(tracer),
             {false, false}, setup...),
        window_(window) {
    while (window_.end <= this->now()) window_.next();
    if (window_.begin <= this->now()) begin();
  }

  void sense(Lines lines) override {
    Base::sense(lines);
    if (showing_) second_.sense(lines);
  }
  void request(const BusOp& op) override {
    Base::request(op);
    if (showing_) second_.request(op);
  }

  Stop run(Clk end, const Plant& plant) override {
    while (true) {
      const Clk part = std::min(end, showing_ ? window_.end : window_.begin);
      const Stop stop = Base::run(part, plant);
      if (showing_) {
        this->follow(stop, plant);
        if ((stop.why & kSample) != 0) this->compare();  // a run may end inside a window
        this->state().count_as(second_.state());  // the traced chip evaluates every clock
        if (this->now() == window_.end) finish();
      }
      if (!showing_ && this->now() >= window_.begin) begin();
      if (stop.why != kLimit || this->now() >= end) return stop;
    }
  }

 private:
  void begin() {
    this->hand_over();
    second_.tracer().moved();
    showing_ = true;
  }

  void finish() {
    this->compare();
    showing_ = false;
    second_.tracer().flush();
    window_.next();
  }

  WaveWindow window_;
  bool showing_ = false;
};

}  // namespace trammel::cosim
