// SPDX-License-Identifier: Apache-2.0
//
// What a trigger may name of a run of gantry.
#pragma once

#include <cstddef>
#include <vector>

#include "cosim/trigger.hpp"

namespace trammel::gantry {

enum class SignalOf : std::size_t { kPosition, kVelocity, kForce, kError, kRegion };

inline const std::vector<cosim::Signal>& signals() {
  static const std::vector<cosim::Signal> all{
      {{"position", "", "position of the observer", 32, true}, false},
      {{"velocity", "", "velocity of the observer", 23, true}, false},
      {{"force", "", "force of motor 1", 11, true}, false},
      {{"error", "count", "error of position", 32, true}, false},
      {{"region", "", "region of the last sample", 2, false}, false}};
  return all;
}

// All forms of a trigger, for people.
inline constexpr char kTriggerHelp[] =
    "drive (a pin of a bridge or of the serial line changes), hi (the chip interrupts), irq (the "
    "chip or the timer interrupts), at 10ms, rise|fall|change region, velocity > 20, each with "
    "`after TIME` behind it if wanted";

inline const cosim::TriggerForms& triggers() {
  static const cosim::TriggerForms forms = cosim::stop_forms(signals(), kTriggerHelp);
  return forms;
}

}  // namespace trammel::gantry
