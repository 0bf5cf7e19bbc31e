// SPDX-License-Identifier: Apache-2.0
//
// Addresses of a chip with a processor inside, rtl/chips/soc_host.sv. Freestanding.
#pragma once

#include <cstdint>

namespace trammel::sw::soc_map {

inline constexpr std::uint32_t kChip = 0x8000'0000;  // registers of the IC
// A read of either is answered when one of its bits is set.
inline constexpr std::uint32_t kWait = 0xC000'0000;      // interrupt, received byte
inline constexpr std::uint32_t kWaitSend = 0xC000'0008;  // these, or the serial port can send
inline constexpr std::uint32_t kWaitIrq = 1u << 0;
inline constexpr std::uint32_t kWaitReceived = 1u << 1;
inline constexpr std::uint32_t kWaitCanSend = 1u << 2;
inline constexpr std::uint32_t kUart = 0xC000'0004;      // write: sends; read: takes
inline constexpr std::uint32_t kUartEmpty = 1u << 31;
inline constexpr std::uint32_t kUartLostShift = 8;       // 8 bits: bytes lost, up to 255
inline constexpr std::uint32_t kChipBytes = 1024;        // of registers of the IC

// Words at the begin of the memory, behind the first instruction: what a test bench, a loader or
// a debugger finds there.
inline constexpr std::uint32_t kHeader = 0x4;   // its words:
inline constexpr std::uint32_t kIsProgram = 0;  // kMagic
inline constexpr std::uint32_t kSetup = 1;      // address of what a loader may fill in
inline constexpr std::uint32_t kReport = 2;     // address of a pointer to the Mailbox, 0 at first
inline constexpr std::uint32_t kFree = 3;       // memory from here ...
inline constexpr std::uint32_t kLimit = 4;      // ... to here is used by nothing
inline constexpr std::uint32_t kMagic = 0x4C4D5254;  // "TRML"

}  // namespace trammel::sw::soc_map
