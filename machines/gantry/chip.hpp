// SPDX-License-Identifier: Apache-2.0
//
// The chip gantry_tau as the loop sees it: its registers on a 32-bit bus beside a timer, a
// converter that samples the plant, and a non-volatile memory. The verilated model stays behind
// this header.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "cosim/machine_chip.hpp"
#include "machines/gantry/pins.hpp"

namespace trammel::gantry {

inline constexpr int kStoreWords = 64;
using Store = std::array<std::uint16_t, kStoreWords>;  // calibration: 62 words, their checksum

inline constexpr cosim::Clk kLook = 50'000;  // from one look at what figures are of to the next

struct ChipSetup {
  cosim::Clk sample_clk = 50'000;  // from one sample of the record to the next
  Store store{};                   // what the non-volatile memory holds at power-on
};

// What a sample of the record takes from inside the chip.
struct Words {
  std::int32_t position = 0;  // 2^-14 of a stripe period
  std::int32_t velocity = 0;  // 2^-9 of that a tick; bit 0 is its source
  std::uint32_t ticks = 0;    // of conversion
  std::uint16_t phase = 0;    // 2^14 a period
  std::uint8_t region = 0;
  bool known = false;                            // of the phase
  std::array<std::int32_t, kMotors> force{};     // -1023 to 1023
  std::array<std::uint16_t, 5> codes{};          // last ones: A, dA, B, dB, current
  std::uint16_t malformed = 0, lost = 0;         // received frames
};

struct GantryChip : cosim::MachineChip {
  virtual Words words() const = 0;
  virtual const Store& store() const = 0;  // as the non-volatile memory is now
};

// As the run asks; with a window its waves are dumped into run.wave_file. Where the chip that dumps
// them differs from the one that runs, the assertion waves_are_exact fails.
std::unique_ptr<GantryChip> make_verilated_chip(const cosim::RunOptions& run,
                                                const std::optional<cosim::WaveWindow>& window,
                                                const ChipSetup& setup);

std::unique_ptr<GantryChip> make_twin_chip(const ChipSetup& setup);  // twin.cpp

}  // namespace trammel::gantry
