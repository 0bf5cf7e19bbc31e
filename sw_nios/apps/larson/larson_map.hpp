// SPDX-License-Identifier: Apache-2.0
//
// Addresses of the machine larson as the processor sees them, whose every access is of 32 bits: the
// chip's four words of 16 bits (Larson 1974, section II), each at 4 n for its own offset 2 n, what
// the chip has behind them, and what the platform adds.
#pragma once

#include <cstdint>

#include "sw_nios/hal/platform_map.hpp"

namespace trammel::sw::larson_map {

constexpr std::uint32_t count(std::uint32_t axis) { return 8 * axis; }
constexpr std::uint32_t status(std::uint32_t axis) { return 8 * axis + 4; }

// Bits of a status word above the rate.
inline constexpr std::uint32_t kRate = 0xFFF;
inline constexpr std::uint32_t kBusy = 1u << 12;
inline constexpr std::uint32_t kForward = 1u << 13;
inline constexpr std::uint32_t kLimit = 1u << 14;  // read: a switch is closed; written 1: reset
inline constexpr std::uint32_t kReset = kLimit;
inline constexpr std::uint32_t kEnable = 1u << 15;
inline constexpr std::uint32_t kTerminal = 0xFFFF;  // minus zero, of a count

inline constexpr std::uint32_t kVector = 0x10;  // a read takes the interrupt it names
inline constexpr std::uint32_t kErrByte = 0x18;  // byte writes so far
inline constexpr std::uint32_t kVectorX = 0340;
inline constexpr std::uint32_t kVectorY = 0344;

// The eight bytes of the four words, of which a write is a byte write.
inline constexpr std::uint32_t kBytes = 0x40;
constexpr std::uint32_t byte(std::uint32_t number) { return kBytes + 4 * number; }

using platform_map::kIrq;
using platform_map::kIrqChip;
using platform_map::kIrqTimer;
using platform_map::kTimer;

}  // namespace trammel::sw::larson_map
