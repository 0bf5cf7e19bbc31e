// SPDX-License-Identifier: Apache-2.0
//
// Which clocks of a run are dumped. Without a window of the user's own: 2 ms around the trigger;
// without a trigger either, the drives' start is it, because the gates are off before.
#pragma once

#include <optional>
#include <vector>

#include "cosim/kung/trigger.hpp"
#include "cosim/kung/types.hpp"

namespace trammel::kung {

inline constexpr double kAfterTriggerS = 0.0018;  // of the default window; run.wave_pre_s before it
inline constexpr double kEveryWindowS = 0.0002;   // default window of run.wave_every_s

// What a session does for waves: looks for the trigger, or dumps a window, or neither.
struct Waves {
  TriggerSearch* search = nullptr;  // the run ends when it has found its trigger
  std::optional<WaveWindow> window;
};

// The event at which the window hangs; none when it counts from the start of the run. Throws as
// parse_trigger() does.
std::optional<Trigger> wave_trigger(const RunOptions& run);

// Whether the user named that event: then its absence is an error.
inline bool trigger_asked(const RunOptions& run) { return !run.wave_trigger.empty(); }

// Where the window begins to count when there is no trigger, or none came.
cosim::Clk wave_origin(const RunOptions& run);

// The window around edge `origin`; it may begin before edge 0, which is then the first one shown.
WaveWindow wave_window(const RunOptions& run, cosim::Clk origin);

}  // namespace trammel::kung
