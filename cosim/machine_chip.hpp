// SPDX-License-Identifier: Apache-2.0
//
// What every machine's chip reports besides what the loop needs.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "cosim/assertion.hpp"
#include "cosim/cosim.hpp"
#include "cosim/run.hpp"
#include "cosim/waves.hpp"

namespace trammel::cosim {

struct MachineChip : Chip {
  virtual Clk evaluated() const = 0;  // edges evaluated; the others were leapt over
  virtual std::vector<DomainActivity> activity() const { return {}; }
  virtual Clk host_rise() const { return kNever; }  // edge at which the pin HI last rose
  // Changes a bit of a register at once, or only asks whether there is one of that name.
  virtual bool flip(const std::string& bit, bool really) {
    static_cast<void>(bit), static_cast<void>(really);
    return false;
  }
  // The first assertion that failed, if the chip checks them.
  virtual std::optional<FailedAssertion> failed_assertion() const { return {}; }
};

// Completes the result of a run that began at `started` and dumped the clocks of `window`. A failed
// assertion is the reason for its end.
void close_result(RunResult& result, const MachineChip& chip,
                  const std::optional<WaveWindow>& window,
                  std::chrono::steady_clock::time_point started);

}  // namespace trammel::cosim
