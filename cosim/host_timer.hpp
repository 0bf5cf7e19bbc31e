// SPDX-License-Identifier: Apache-2.0
//
// The timer beside a chip on its processor's bus: it interrupts once, the given number of
// clocks after it was written.
#pragma once

#include <algorithm>
#include <cstdint>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

class HostTimer {
 public:
  bool irq() const { return irq_; }

  // By a transfer that ends at `edge`; 0 is off.
  void write(Clk edge, std::uint32_t clocks) {
    end_ = clocks == 0 ? kNever : edge + clocks;
    irq_ = false;
  }

  // Edges from `edge` on without its end, which is a separate edge: at least 1.
  Clk waiting(Clk edge) const {
    return end_ == kNever ? kNever : std::max<Clk>(1, end_ - edge);
  }

  void pass(Clk edge) {
    if (edge != end_) return;
    end_ = kNever;
    irq_ = true;
  }

 private:
  Clk end_ = kNever;
  bool irq_ = false;
};

}  // namespace trammel::cosim
