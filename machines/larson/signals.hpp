// SPDX-License-Identifier: Apache-2.0
//
// What a trigger may name of a run of larson: words of the chip and of the program.
#pragma once

#include <cstddef>
#include <vector>

#include "cosim/trigger.hpp"

namespace trammel::larson {

enum class SignalOf : std::size_t { kCount, kStatus, kWaiting, kCall, kSwitches };

inline const std::vector<cosim::Signal>& signals() {
  static const std::vector<cosim::Signal> all{
      {{"count", "", "count register, complement of the steps left", 16, false}, true},
      {{"status", "", "rate and status word", 16, false}, true},
      {{"waiting", "", "pulses in the buffer", 16, false}, true},
      {{"call", "", "calls of the script that have ended", 32, false}, false},
      {{"switches", "", "closed: bits X low, X high, Y low, Y high", 4, false}, false}};
  return all;
}

// All forms of a trigger, for people.
inline constexpr char kTriggerHelp[] =
    "drive (a pin of a translator changes), hi (the chip interrupts), irq (the chip or the timer "
    "interrupts), at 10ms, rise|fall|change x.waiting, y.count == 65535, each with `after TIME` "
    "behind it if wanted";

inline const cosim::TriggerForms& triggers() {
  static const cosim::TriggerForms forms = cosim::stop_forms(signals(), kTriggerHelp);
  return forms;
}

}  // namespace trammel::larson
