// Generated from rtl/chips/mcafee_xy.rdl by scripts/tool gen-register-map; do not edit.
// SPDX-License-Identifier: Apache-2.0
//
// Registers of mcafee_xy: addresses in bytes, bits, and what reads and writes do. Those of a
// register file are at base + offset, a system register at its own address.
#pragma once

#include <array>
#include <cstdint>

namespace trammel::mcafee_xy_regs {

// system
inline constexpr std::uint32_t kId = 0x00u, kIdVersionShift = 0u, kIdVersionMask = 0x0000FFFFu,
    kIdChipShift = 16u, kIdChipMask = 0xFFFF0000u, kIdValue = 0x4D430001u;
inline constexpr std::uint32_t kPortB = 0x04u, kPortBWriteStrobe = 0x1u, kPortBReadStrobe = 0x2u,
    kPortBPs = 0x4u, kPortBRead = 0x8u, kPortBY = 0x10u;
inline constexpr std::uint32_t kPortC = 0x08u, kPortCToPartShift = 0u,
    kPortCToPartMask = 0x000000FFu, kPortCFromPartShift = 0u, kPortCFromPartMask = 0x000000FFu;
inline constexpr std::uint32_t kStatus = 0x0Cu, kStatusBusy = 0x1u, kStatusRefused = 0x2u,
    kStatusSample = 0x4u;
inline constexpr std::uint32_t kFeedIn = 0x10u, kFeedInCShift = 0u, kFeedInCMask = 0x000000FFu,
    kFeedInCcShift = 8u, kFeedInCcMask = 0x0000FF00u;
inline constexpr std::uint32_t kFeedOut = 0x14u, kFeedOutVShift = 0u, kFeedOutVMask = 0x000000FFu,
    kFeedOutReady = 0x80000000u;
inline constexpr std::uint32_t kIrq = 0x18u, kIrqX = 0x1u, kIrqY = 0x2u;
inline constexpr std::uint32_t kLimits = 0x1Cu, kLimitsXLow = 0x1u, kLimitsXHigh = 0x2u,
    kLimitsYLow = 0x4u, kLimitsYHigh = 0x8u;
inline constexpr std::uint32_t kReset = 0x20u, kResetStrobe = 0x1u;

enum class Access { kRead, kWrite, kReadWrite, kWriteOneToClear };

// A register at its own address, and what a read and a write do to its bits.
struct Register {
  const char* name;  // "x.CTRL", "TICK"
  std::uint32_t address;
  std::uint32_t reset;
  std::uint32_t readable;
  std::uint32_t written;  // bits that keep what is written
  std::uint32_t locked;   // of them, those that LOCK protects
  std::uint32_t cleared;  // bits that a written one clears
  std::uint32_t pulsed;   // bits that a written one sets for one clock
};

// Bits of a register, and the number in them.
struct Field {
  const char* name;  // "CTRL.enable"; a register of one field has its name alone
  const char* help;
  std::uint32_t address;  // of its register; in a register file, an offset
  int shift;
  int width;
  int bits;  // of the number: bits of the field above repeat its sign, or are 0
  bool is_signed;
  bool of_axis;  // each register file has one
  Access access;
};

// By address.
inline constexpr std::array<Register, 9> kRegisters{{
    {"ID", 0x000u, 0x4D430001u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"PORT_B", 0x004u, 0x00000000u, 0x0000001Fu, 0x0000001Fu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"PORT_C", 0x008u, 0x00000000u, 0x000000FFu, 0x000000FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"STATUS", 0x00Cu, 0x00000000u, 0x00000007u, 0x00000000u, 0x00000000u, 0x00000006u, 0x00000000u},
    {"FEED_IN", 0x010u, 0x00000000u, 0x0000FFFFu, 0x0000FFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"FEED_OUT", 0x014u, 0x00000000u, 0x800000FFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"IRQ", 0x018u, 0x00000000u, 0x00000003u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"LIMITS", 0x01Cu, 0x00000000u, 0x0000000Fu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"RESET", 0x020u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000001u},
}};

inline constexpr std::array<Field, 23> kFields{{
    {"ID.version", "identity of the IC and version of its register map", 0x00u, 0, 16, 16, false, false, Access::kRead},
    {"ID.chip", "identity of the IC and version of its register map", 0x00u, 16, 16, 16, false, false, Access::kRead},
    {"PORT_B.write_strobe", "WR strobe", 0x04u, 0, 1, 1, false, false, Access::kReadWrite},
    {"PORT_B.read_strobe", "RD strobe", 0x04u, 1, 1, 1, false, false, Access::kReadWrite},
    {"PORT_B.ps", "PS: 0 command and status, 1 data", 0x04u, 2, 1, 1, false, false, Access::kReadWrite},
    {"PORT_B.read", "R/W: 0 the processor drives the bus, 1 the part drives it", 0x04u, 3, 1, 1, false, false, Access::kReadWrite},
    {"PORT_B.y", "0 selects X, 1 selects Y", 0x04u, 4, 1, 1, false, false, Access::kReadWrite},
    {"PORT_C.to_part", "byte for the part", 0x08u, 0, 8, 8, false, false, Access::kWrite},
    {"PORT_C.from_part", "byte that the last RD pulse read", 0x08u, 0, 8, 8, false, false, Access::kRead},
    {"STATUS.busy", "a pulse, its set-up or hold time runs; the pins do not change", 0x0Cu, 0, 1, 1, false, false, Access::kRead},
    {"STATUS.refused", "a strobe started nothing: busy, or against the direction", 0x0Cu, 1, 1, 1, false, false, Access::kWriteOneToClear},
    {"STATUS.sample", "a sample of X was published", 0x0Cu, 2, 1, 1, false, false, Access::kWriteOneToClear},
    {"FEED_IN.c", "curvature", 0x10u, 0, 8, 8, false, false, Access::kReadWrite},
    {"FEED_IN.cc", "magnitude of its change ahead", 0x10u, 8, 8, 8, false, false, Access::kReadWrite},
    {"FEED_OUT.v", "speed; 0 until it is ready", 0x14u, 0, 8, 8, false, false, Access::kRead},
    {"FEED_OUT.ready", "v is the speed for FEED_IN", 0x14u, 31, 1, 1, false, false, Access::kRead},
    {"IRQ.x", "pin HI of X", 0x18u, 0, 1, 1, false, false, Access::kRead},
    {"IRQ.y", "pin HI of Y", 0x18u, 1, 1, 1, false, false, Access::kRead},
    {"LIMITS.x_low", "lower end of X", 0x1Cu, 0, 1, 1, false, false, Access::kRead},
    {"LIMITS.x_high", "upper end of X", 0x1Cu, 1, 1, 1, false, false, Access::kRead},
    {"LIMITS.y_low", "lower end of Y", 0x1Cu, 2, 1, 1, false, false, Access::kRead},
    {"LIMITS.y_high", "upper end of Y", 0x1Cu, 3, 1, 1, false, false, Access::kRead},
    {"RESET", "pin RST of both parts: 1 pulls it low for 80 clocks; their samples then coincide", 0x20u, 0, 1, 1, false, false, Access::kWrite},
}};

}  // namespace trammel::mcafee_xy_regs
