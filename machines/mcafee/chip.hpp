// SPDX-License-Identifier: Apache-2.0
//
// mcafee_xy as the loop sees it: its registers on a 32-bit bus beside a timer, a converter of 8
// bits an axis. A sample is one of X. The verilated model stays behind this header.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "parts/lm628/chip.hpp"
#include "machines/mcafee/pins.hpp"

namespace trammel::mcafee {

inline constexpr int kClockMHz = 6;  // McAfee's parts; there are some of 8 MHz

struct McafeeChip : cosim::MachineChip {
  virtual lm628::Words words(int axis) const = 0;  // what its part holds
  virtual bool host_irq(int axis) const = 0;       // pin HI; irq() is also the timer's
};

// As the run asks; with a window its waves are dumped into run.wave_file. Where the chip that dumps
// them differs from the one that runs, the assertion waves_are_exact fails.
std::unique_ptr<McafeeChip> make_verilated_chip(
    const cosim::RunOptions& run, const std::optional<cosim::WaveWindow>& window = {},
    int clock_MHz = kClockMHz);

}  // namespace trammel::mcafee
