// SPDX-License-Identifier: Apache-2.0
//
// What the chip of every machine tells besides what the loop asks.
#pragma once

#include <chrono>
#include <optional>

#include "cosim/cosim.hpp"
#include "cosim/machine.hpp"
#include "cosim/promise.hpp"
#include "cosim/waves.hpp"

namespace trammel::cosim {

struct MachineChip : Chip {
  virtual Clk evaluated() const = 0;  // edges evaluated; the others were leapt over
  virtual Clk host_rise() const { return kNever; }  // edge at which the pin HI last rose
  // The first promise that did not hold, if the chip looks at them.
  virtual std::optional<BrokenPromise> broken_promise() const { return {}; }
};

// What a session of any machine knows at the end of a run that began at `started` and dumped the
// clocks of `window`. A promise that did not hold is why it ended.
void close_result(RunResult& result, const MachineChip& chip,
                  const std::optional<WaveWindow>& window,
                  std::chrono::steady_clock::time_point started);

}  // namespace trammel::cosim
