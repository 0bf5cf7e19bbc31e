// SPDX-License-Identifier: Apache-2.0
//
// A hosted chip that is a bit-exact twin: only clocks in which something happens are stepped.
#pragma once

#include "cosim/hosted.hpp"
#include "models/exact/math/timer.hpp"

namespace trammel::cosim {

template <class Base, class State, class Twin>
class HostedTwin : public Hosted<Base, State> {
 protected:
  using Hosted<Base, State>::state_;

  explicit HostedTwin(const Twin& twin) : twin_(twin) {}

  // The reset's edges; the synchronisers, which have no reset, follow the pins.
  void reset() {
    for (int i = 0; i < 4; ++i) twin_.step(in_);
    twin_.reset();
  }

  virtual void put_transfer() {}  // its pins before an edge
  void raise(Clk) override {
    twin_.step(in_);
    ++state_.evaluated;
  }

  Twin twin_;
  typename Twin::In in_;

 private:
  Clk settle(Clk, bool bus) final {
    if (bus) put_transfer();
    return bus ? 1 : twin_.next(in_);
  }
  void leap(Clk, Clk clocks) final { twin_.advance(static_cast<exact::Gap>(clocks)); }
};

}  // namespace trammel::cosim
