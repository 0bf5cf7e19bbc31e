// SPDX-License-Identifier: Apache-2.0
//
// Bus for a chip without one: its pins are words, number n at byte 4 n. A write sets the input word
// of that number, a read returns the output word; beside them is a timer of the platform.
#pragma once

#include <cstdint>

namespace trammel::sw::pin_map {

constexpr std::uint32_t word(std::uint32_t number) { return 4 * number; }

inline constexpr std::uint32_t kTimer = 0x100;  // [clk] until its one interrupt; 0 = off
inline constexpr std::uint32_t kIrq = 0x104;    // causes of the interrupt
inline constexpr std::uint32_t kIrqTimer = 1u << 0;

}  // namespace trammel::sw::pin_map
