// SPDX-License-Identifier: Apache-2.0
//
// The words of an LM628's samples, as trace.csv shows them and a trigger names them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cosim/trigger.hpp"
#include "parts/lm628/chip.hpp"

namespace trammel::lm628 {

inline constexpr double kPerCount = 65536;  // of a position or speed

struct PartWord : cosim::Word {
  std::int64_t (*read)(const Words&);
  int fraction = 0;       // binary places of what is read
  int hidden = 0;         // of them, those that a trigger does not see
  double resolution = 1;  // [unit] of its series on the report page
};

inline constexpr PartWord kWords[] = {
    {{"desired_count", "count", "trajectory generator", 32, true},
     [](const Words& w) { return w.position; }, 16, 16, 1e-3},
    {{"desired_speed", "count per sample", "trajectory generator", 32, true},
     [](const Words& w) { return std::int64_t{w.speed}; }, 16, 0, 1e-5},
    {{"real_count", "count", "what the part counted", 32, true},
     [](const Words& w) { return std::int64_t{w.actual}; }},
    {{"e", "count", "position error", 16, true},
     [](const Words& w) { return std::int64_t{w.error}; }},
    {{"p", "", "kp e, before its limit of 16 bits", 32, true},
     [](const Words& w) { return std::int64_t{w.proportional}; }},
    {{"i", "", "integral term", 16, true},
     [](const Words& w) { return std::int64_t{w.integral}; }},
    {{"d", "", "derivative term", 32, true},
     [](const Words& w) { return std::int64_t{w.derivative}; }},
    {{"output", "", "of the filter", 16, true},
     [](const Words& w) { return std::int64_t{w.output}; }},
    {{"status", "", "status byte", 8, false},
     [](const Words& w) { return std::int64_t{w.status}; }},
};

// Of one part; of_axis where there are two.
std::vector<cosim::Signal> signals_of_part(bool of_axis);

const std::vector<cosim::Signal>& signals();

// All forms of a trigger, for people.
inline constexpr char kTriggerHelp[] =
    "drive (a converter's code changes), hi (the pin HI rises), irq (HI or the timer interrupts), "
    "at 10ms, rise|fall|change status.breakpoint, e > 20, each with `after TIME` behind it if "
    "wanted";

// The value of signals()[signal].
std::int64_t word(const Words& words, std::size_t signal);

}  // namespace trammel::lm628
