// SPDX-License-Identifier: Apache-2.0
//
// The LM628 as the loop sees it: its host port on a 32-bit bus beside a timer, its outputs behind a
// converter, or at an H-bridge. The verilated models and the twin stay behind this header.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>

#include "cosim/cosim.hpp"
#include "parts/lm628/pins.hpp"
#include "parts/lm628/options.hpp"
#include "cosim/run.hpp"
#include "cosim/machine_chip.hpp"

namespace trammel::lm628 {

// What the part holds when the results of a sample are published.
struct Words {
  std::int64_t position = 0;      // desired [2^-16 count]
  std::int32_t speed = 0;         // desired [2^-16 count/sample]
  std::int32_t actual = 0;        // [count]
  std::int32_t error = 0;         // 16 bits [count]
  std::int32_t proportional = 0;  // kp e, before any limit
  std::int32_t integral = 0;      // ki s16, within il
  std::int32_t derivative = 0;    // held for n + 1 samples
  std::int32_t output = 0;        // 16 bits
  std::uint8_t status = 0;
};

// The error as positions stand now, where a sample that turned the motor off has set the desired
// one back, and kp times it.
inline void derive_error(Words& w, std::int64_t kp) {
  w.error = static_cast<std::int32_t>(
      std::clamp<std::int64_t>((w.position >> 16) - w.actual, -32768, 32767));
  w.proportional = static_cast<std::int32_t>(kp * w.error);
}

struct Lm628Chip : cosim::MachineChip {
  virtual Words words() const = 0;
  virtual bool host_irq() const = 0;  // pin HI; irq() is also the timer's
};

// As the run asks; with a window its waves are dumped into run.wave_file. If the chip that dumps
// them differs from the one that runs, the assertion waves_are_exact fails.
std::unique_ptr<Lm628Chip> make_verilated_chip(
    const cosim::RunOptions& run, const std::optional<cosim::WaveWindow>& window = {},
    const PartOptions& part = {});
std::unique_ptr<Lm628Chip> make_twin_chip(const PartOptions& part = {});

}  // namespace trammel::lm628
