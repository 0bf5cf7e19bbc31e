// SPDX-License-Identifier: Apache-2.0
//
// What the chip of every machine tells besides what the loop asks.
#pragma once

#include <optional>

#include "cosim/cosim.hpp"
#include "cosim/promise.hpp"

namespace trammel::cosim {

struct MachineChip : Chip {
  virtual Clk evaluated() const = 0;  // edges evaluated; the others were leapt over
  virtual Clk host_rise() const { return kNever; }  // edge at which the pin HI last rose
  // The first promise that did not hold, if the chip looks at them.
  virtual std::optional<BrokenPromise> broken_promise() const { return {}; }
};

}  // namespace trammel::cosim
