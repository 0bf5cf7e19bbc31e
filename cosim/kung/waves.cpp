// SPDX-License-Identifier: Apache-2.0
#include "cosim/kung/waves.hpp"

namespace trammel::kung {

std::optional<Trigger> TriggerSearch::event(const cosim::RunBasics& run) {
  const auto text = cosim::wave_trigger_text(run, kWaveStart);
  if (!text) return {};
  return parse_trigger(*text);
}

}  // namespace trammel::kung
