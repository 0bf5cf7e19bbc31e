// Generated from rtl/chips/mcafee_xy.rdl by scripts/gen_regs.py; do not edit.
// SPDX-License-Identifier: Apache-2.0
//
// Registers of mcafee_xy for its twin: names of the firmware's header, and
// what a write does to the stored bits of each.
#pragma once

#include <array>
#include <cstdint>

namespace trammel::exact::mcafee_xy_map {


// system
inline constexpr std::uint32_t kId = 0x00u;
inline constexpr std::uint32_t kIdVersionShift = 0u;
inline constexpr std::uint32_t kIdVersionMask = 0x0000FFFFu;
inline constexpr std::uint32_t kIdChipShift = 16u;
inline constexpr std::uint32_t kIdChipMask = 0xFFFF0000u;
inline constexpr std::uint32_t kIdValue = 0x4D430001u;
inline constexpr std::uint32_t kPortB = 0x04u;
inline constexpr std::uint32_t kPortBWriteStrobe = 0x1u;
inline constexpr std::uint32_t kPortBReadStrobe = 0x2u;
inline constexpr std::uint32_t kPortBPs = 0x4u;
inline constexpr std::uint32_t kPortBRead = 0x8u;
inline constexpr std::uint32_t kPortBY = 0x10u;
inline constexpr std::uint32_t kPortC = 0x08u;
inline constexpr std::uint32_t kPortCToPartShift = 0u;
inline constexpr std::uint32_t kPortCToPartMask = 0x000000FFu;
inline constexpr std::uint32_t kPortCFromPartShift = 0u;
inline constexpr std::uint32_t kPortCFromPartMask = 0x000000FFu;
inline constexpr std::uint32_t kStatus = 0x0Cu;
inline constexpr std::uint32_t kStatusBusy = 0x1u;
inline constexpr std::uint32_t kStatusRefused = 0x2u;
inline constexpr std::uint32_t kStatusSample = 0x4u;
inline constexpr std::uint32_t kFeedIn = 0x10u;
inline constexpr std::uint32_t kFeedInCShift = 0u;
inline constexpr std::uint32_t kFeedInCMask = 0x000000FFu;
inline constexpr std::uint32_t kFeedInCcShift = 8u;
inline constexpr std::uint32_t kFeedInCcMask = 0x0000FF00u;
inline constexpr std::uint32_t kFeedOut = 0x14u;
inline constexpr std::uint32_t kFeedOutVShift = 0u;
inline constexpr std::uint32_t kFeedOutVMask = 0x000000FFu;
inline constexpr std::uint32_t kFeedOutReady = 0x80000000u;
inline constexpr std::uint32_t kIrq = 0x18u;
inline constexpr std::uint32_t kIrqX = 0x1u;
inline constexpr std::uint32_t kIrqY = 0x2u;
inline constexpr std::uint32_t kLimits = 0x1Cu;
inline constexpr std::uint32_t kLimitsXLow = 0x1u;
inline constexpr std::uint32_t kLimitsXHigh = 0x2u;
inline constexpr std::uint32_t kLimitsYLow = 0x4u;
inline constexpr std::uint32_t kLimitsYHigh = 0x8u;
inline constexpr std::uint32_t kReset = 0x20u;
inline constexpr std::uint32_t kResetStrobe = 0x1u;

struct Register {
  std::uint32_t address;
  std::uint32_t reset;
  std::uint32_t written;  // bits that keep what is written
  std::uint32_t locked;   // of them, those that LOCK protects
  std::uint32_t pulsed;   // bits that a written one sets for one clock
};

inline constexpr std::array<Register, 5> kRegisters{{
    {0x000u, 0x4D430001u, 0x00000000u, 0x00000000u, 0x00000000u},  // id
    {0x004u, 0x00000000u, 0x0000001Fu, 0x00000000u, 0x00000000u},  // port_b
    {0x008u, 0x00000000u, 0x000000FFu, 0x00000000u, 0x00000000u},  // port_c
    {0x010u, 0x00000000u, 0x0000FFFFu, 0x00000000u, 0x00000000u},  // feed_in
    {0x020u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000001u},  // reset
}};

}  // namespace trammel::exact::mcafee_xy_map
