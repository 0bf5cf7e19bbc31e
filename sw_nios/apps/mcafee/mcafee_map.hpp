// SPDX-License-Identifier: Apache-2.0
//
// What the platform of mcafee_xy adds to the registers of the chip, above them on the bus.
#pragma once

#include <cstdint>

namespace trammel::sw::mcafee_map {

inline constexpr std::uint32_t kTimer = 0x100;  // [clk] until its one interrupt; 0 = off
inline constexpr std::uint32_t kIrq = 0x104;    // causes of the interrupt
inline constexpr std::uint32_t kIrqHost = 1u << 0;  // HI of a part, see the chip's IRQ
inline constexpr std::uint32_t kIrqTimer = 1u << 1;

}  // namespace trammel::sw::mcafee_map
