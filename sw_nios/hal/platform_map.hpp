// SPDX-License-Identifier: Apache-2.0
//
// Registers of the platform beside a chip on its processor's bus; those of the chip are below them.
#pragma once

#include <cstdint>

namespace trammel::sw::platform_map {

inline constexpr std::uint32_t kFirst = 0x100;
inline constexpr std::uint32_t kTimer = 0x100;      // [clk] until its one interrupt; 0 = off
inline constexpr std::uint32_t kIrq = 0x104;        // causes of the interrupt
inline constexpr std::uint32_t kIrqChip = 1u << 0;  // see the chip's own registers
inline constexpr std::uint32_t kIrqTimer = 1u << 1;

}  // namespace trammel::sw::platform_map
