// Generated from rtl/chips/mcafee_xy.rdl by scripts/gen_regs.py; do not edit.
// SPDX-License-Identifier: Apache-2.0
//
// Byte addresses and bits of the registers of mcafee_xy: those of a file
// are at base + offset, a system register at its own address.
#pragma once

#include <cstdint>

namespace trammel::sw::mcafee_xy_regs {


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

}  // namespace trammel::sw::mcafee_xy_regs
