// SPDX-License-Identifier: Apache-2.0
//
// Command set of the LM628 (data sheet SNVS781C): opcodes, words that follow them, bits.
#pragma once

#include <cstdint>

namespace trammel::exact {

enum class Opcode : std::uint8_t {
  kReset = 0x00,
  kStt = 0x01,  // start
  kDfh = 0x02,  // define home
  kSip = 0x03,  // set index position
  kUdf = 0x04,  // update filter
  kPort8 = 0x05,
  kPort12 = 0x06,
  kRddv = 0x07,  // read desired velocity
  kRddp = 0x08,  // read desired position
  kRdip = 0x09,  // read index position
  kRdrp = 0x0A,  // read real position
  kRdrv = 0x0B,  // read real velocity
  kRdsigs = 0x0C,
  kRdsum = 0x0D,  // read integration sum
  kLpes = 0x1A,   // load position error for stopping
  kLpei = 0x1B,   // load position error for interrupt
  kMski = 0x1C,   // mask interrupts
  kRsti = 0x1D,   // reset interrupts
  kLfil = 0x1E,   // load filter
  kLtrj = 0x1F,   // load trajectory
  kSbpa = 0x20,   // set breakpoint, absolute
  kSbpr = 0x21,   // set breakpoint, relative
};

// Bits of the status byte that are events.
inline constexpr int kCommandError = 1;
inline constexpr int kTrajectoryComplete = 2;
inline constexpr int kIndex = 3;
inline constexpr int kWraparound = 4;
inline constexpr int kPositionError = 5;
inline constexpr int kBreakpoint = 6;

// Bits of the control word of LTRJ.
inline constexpr unsigned kForward = 1u << 12;
inline constexpr unsigned kVelocityMode = 1u << 11;
inline constexpr unsigned kStopSmoothly = 1u << 10;
inline constexpr unsigned kStopAbruptly = 1u << 9;
inline constexpr unsigned kStopOff = 1u << 8;
inline constexpr unsigned kStops = kStopSmoothly | kStopAbruptly | kStopOff;

constexpr bool is_known(std::uint8_t code) {
  return code <= 0x0D || (code >= 0x1A && code <= 0x21);
}

// Words to be written after the opcode; the first of LFIL and LTRJ says how many more follow.
constexpr int words_due(std::uint8_t code) {
  if (code >= 0x1A && code <= 0x1F) return 1;
  return code == 0x20 || code == 0x21 ? 2 : 0;
}

constexpr int words_after_control(std::uint8_t code, std::uint16_t control) {
  const auto bit = [&](int n) { return control >> n & 1; };
  if (code == 0x1E) return bit(3) + bit(2) + bit(1) + bit(0);
  if (code == 0x1F) return 2 * (bit(5) + bit(3) + bit(1));
  return 0;
}

// Words that can be read once the command has been executed.
constexpr int words_replied(std::uint8_t code) {
  if (code >= 0x07 && code <= 0x0A) return 2;
  return code >= 0x0B && code <= 0x0D ? 1 : 0;
}

}  // namespace trammel::exact
