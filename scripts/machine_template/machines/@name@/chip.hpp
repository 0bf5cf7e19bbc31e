// SPDX-License-Identifier: Apache-2.0
//
// The chip @name@_pwm as the loop sees it; the verilated models stay behind this header.
#pragma once

#include <memory>
#include <optional>

#include "cosim/pin_bus.hpp"
#include "cosim/run.hpp"

namespace trammel::@name@ {

inline constexpr cosim::Clk kSampleClk = 5000;  // of the record: 0.1 ms, two periods of the PWM

// As the run asks; with a window its waves are dumped into run.wave_file.
std::unique_ptr<cosim::PinnedChip> make_verilated_chip(
    const cosim::RunOptions& run, const std::optional<cosim::WaveWindow>& window);

}  // namespace trammel::@name@
