// SPDX-License-Identifier: Apache-2.0
//
// What the platform of the chip gantry_tau adds to its registers, above them on the bus.
#pragma once

#include <cstdint>

namespace trammel::sw::gantry_map {

inline constexpr std::uint32_t kPlatform = 0x100;  // from here on
inline constexpr std::uint32_t kTimer = 0x100;     // [clk] until its one interrupt; 0 = off
inline constexpr std::uint32_t kIrq = 0x104;       // causes of the interrupt
inline constexpr std::uint32_t kIrqChip = 1u << 0;  // see the chip's STATUS
inline constexpr std::uint32_t kIrqTimer = 1u << 1;

}  // namespace trammel::sw::gantry_map
