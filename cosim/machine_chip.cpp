// SPDX-License-Identifier: Apache-2.0
#include "cosim/machine_chip.hpp"

namespace trammel::cosim {

void close_result(RunResult& result, const MachineChip& chip,
                  const std::optional<WaveWindow>& window,
                  std::chrono::steady_clock::time_point started) {
  result.clocks = chip.now();
  result.evaluated = chip.evaluated();
  result.activity = chip.activity();
  result.assertion = chip.failed_assertion();
  if (result.assertion) result.end = EndReason::kAssertion;
  if (window) result.waves = wave_spans(*window, result.clocks);
  result.wall_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
}

}  // namespace trammel::cosim
