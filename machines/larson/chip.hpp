// SPDX-License-Identifier: Apache-2.0
//
// The chip larson_xy as the loop sees it: its words on a 32-bit bus beside a timer, and a tick at
// which the record is taken. The verilated model stays behind this header.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "cosim/machine_chip.hpp"
#include "machines/larson/pins.hpp"

namespace trammel::larson {

inline constexpr cosim::Clk kLook = 50'000;  // from one look at what figures are of to the next

struct ChipSetup {
  cosim::Clk sample_clk = 50'000;  // from one sample of the record to the next
};

struct LarsonChip : cosim::MachineChip {
  virtual std::uint32_t words(int axis) const = 0;  // status word and count
  virtual std::uint32_t err_byte() const = 0;
  virtual unsigned requests() const = 0;  // interrupts not yet granted: bit 0 X, bit 1 Y
};

// As the run asks; with a window its waves are dumped into run.wave_file. Where the chip that dumps
// them differs from the one that runs, the assertion waves_are_exact fails.
std::unique_ptr<LarsonChip> make_verilated_chip(const cosim::RunOptions& run,
                                                const std::optional<cosim::WaveWindow>& window,
                                                const ChipSetup& setup);

std::unique_ptr<LarsonChip> make_twin_chip(const ChipSetup& setup);  // twin.cpp

}  // namespace trammel::larson
