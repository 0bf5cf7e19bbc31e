// SPDX-License-Identifier: Apache-2.0
//
// Which clocks of a run are dumped. Without a window from the user: 2 ms around the trigger, or
// without a trigger around the machine's start event.
#pragma once

#include <optional>
#include <string>

#include "cosim/run.hpp"

namespace trammel::cosim {

inline constexpr double kAfterTriggerS = 0.0018;  // of the default window; run.wave_pre_s before it
inline constexpr double kEveryWindowS = 0.0002;   // default window of run.wave_every_s

// Seconds of "10ms"; s, ms, us or ns behind the number, none means s.
std::optional<double> parse_time(const std::string& text);

// Edge of such a time of a run; throws std::invalid_argument that says what is allowed.
Clk parse_edge(const std::string& text, std::int64_t clock_ps);

// Whether the user named the event that the window is anchored to: then its absence is an error.
inline bool trigger_asked(const RunOptions& run) { return !run.wave_trigger.empty(); }

// That event: the user's, or `start` of the default window; none when it counts from the start of
// the run.
std::optional<std::string> wave_trigger_text(const RunOptions& run, const char* start);

// Where the window counts from when there is no trigger, or it never fired.
Clk wave_origin(const RunOptions& run);

// The window around edge `origin`; it may begin before edge 0, which is then the first one shown.
WaveWindow wave_window(const RunOptions& run, Clk origin);

}  // namespace trammel::cosim
