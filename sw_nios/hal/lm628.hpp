// SPDX-License-Identifier: Apache-2.0
//
// Driver of the LM628 (data sheet SNVS781C, AN-693): commands and words through its 8-bit port. As
// the data sheet requires, the busy bit is checked before each command and each word, but not
// between the two bytes of a word. Freestanding.
#pragma once

#include <cstdint>

#include "sw_nios/hal/bus.hpp"

namespace trammel::sw {

// Bus addresses of the port, its reset pin and the machine's timer.
namespace lm628_map {
inline constexpr std::uint32_t kCommand = 0x0;  // PS low: a write is a command, a read the status
inline constexpr std::uint32_t kData = 0x4;     // PS high: one byte
inline constexpr std::uint32_t kReset = 0x8;    // a write strobes RST
inline constexpr std::uint32_t kTimer = 0xC;    // [clk] until its one interrupt; 0 = off
inline constexpr std::uint32_t kIrq = 0x10;     // causes of the interrupt
inline constexpr std::uint32_t kIrqHost = 1u << 0;   // pin HI
inline constexpr std::uint32_t kIrqTimer = 1u << 1;
}  // namespace lm628_map

enum class Lm628Command : std::uint8_t {
  kReset = 0x00,
  kStt = 0x01,
  kDfh = 0x02,
  kSip = 0x03,
  kUdf = 0x04,
  kPort8 = 0x05,
  kPort12 = 0x06,
  kRddv = 0x07,
  kRddp = 0x08,
  kRdip = 0x09,
  kRdrp = 0x0A,
  kRdrv = 0x0B,
  kRdsigs = 0x0C,
  kRdsum = 0x0D,
  kLpes = 0x1A,
  kLpei = 0x1B,
  kMski = 0x1C,
  kRsti = 0x1D,
  kLfil = 0x1E,
  kLtrj = 0x1F,
  kSbpa = 0x20,
  kSbpr = 0x21,
};

// Bits of the status byte; 1 to 6 are also those of MSKI and RSTI.
namespace lm628_status {
inline constexpr std::uint8_t kBusy = 1u << 0;
inline constexpr std::uint8_t kCommandError = 1u << 1;
inline constexpr std::uint8_t kTrajectoryComplete = 1u << 2;
inline constexpr std::uint8_t kIndex = 1u << 3;
inline constexpr std::uint8_t kPositionError = 1u << 5;
inline constexpr std::uint8_t kBreakpoint = 1u << 6;
inline constexpr std::uint8_t kMotorOff = 1u << 7;
}  // namespace lm628_status

// Control word of LTRJ: acceleration, velocity and position follow.
inline constexpr std::uint32_t kLm628AbsoluteMove = 0x002A;

// Commands and words at the addresses of lm628_map, on any bus that has them.
class Lm628Port {
 public:
  // A command keeps the part busy for 94 us at most, RESET for 1.5 ms; a poll takes over 0.4 us.
  static constexpr std::uint32_t kPollLimit = 4096;

  explicit Lm628Port(Bus& bus) : bus_(bus) {}

  bool stuck() const { return stuck_; }  // busy did not clear; nothing was written since

  std::uint8_t status() { return static_cast<std::uint8_t>(bus_.read(lm628_map::kCommand)); }

  // Waits until the part takes the next command or word, and so has executed the last one. Returns
  // false if it is stuck.
  bool ready() {
    for (std::uint32_t polls = 0; !stuck_ && polls < kPollLimit; ++polls) {
      if ((status() & lm628_status::kBusy) == 0) return true;
    }
    stuck_ = true;
    return false;
  }

  void command(Lm628Command code) {
    if (ready()) bus_.write(lm628_map::kCommand, static_cast<std::uint32_t>(code));
  }
  void word(std::uint32_t value) {
    if (!ready()) return;
    bus_.write(lm628_map::kData, value >> 8 & 0xFF);
    bus_.write(lm628_map::kData, value & 0xFF);
  }
  void long_word(std::int32_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    word(bits >> 16);
    word(bits & 0xFFFF);
  }
  std::uint32_t read_word() {
    if (!ready()) return 0;
    const std::uint32_t high = bus_.read(lm628_map::kData) & 0xFF;
    return high << 8 | (bus_.read(lm628_map::kData) & 0xFF);
  }

  void command(Lm628Command code, std::uint32_t value) {
    command(code);
    word(value);
  }
  void command_long(Lm628Command code, std::int32_t value) {
    command(code);
    long_word(value);
  }
  std::int32_t ask_long(Lm628Command code) {
    command(code);
    const std::uint32_t high = read_word();
    return static_cast<std::int32_t>(high << 16 | read_word());
  }

 private:
  Bus& bus_;
  bool stuck_ = false;
};

struct Lm628Filter {
  std::uint32_t kp = 10;
  std::uint32_t ki = 0;
  std::uint32_t kd = 0;
  std::uint32_t il = 0;
  std::uint32_t interval = 1;  // of the derivative term, 1..256 samples
};

// AN-693, "Filter programming": kp, the other coefficients that are not 0, and UDF.
inline void load_filter(Lm628Port& port, const Lm628Filter& f) {
  const std::uint32_t loads = 8u | (f.ki != 0 ? 4u : 0) | (f.kd != 0 ? 2u : 0) |
                              (f.il != 0 ? 1u : 0);
  port.command(Lm628Command::kLfil, (f.interval - 1) << 8 | loads);
  port.word(f.kp);
  if (f.ki != 0) port.word(f.ki);
  if (f.kd != 0) port.word(f.kd);
  if (f.il != 0) port.word(f.il);
  port.command(Lm628Command::kUdf);
}

// LPES: the part turns its motor off at a position error above this limit [count]; 0 loads none.
inline void stop_on_error(Lm628Port& port, std::uint32_t limit) {
  if (limit != 0) port.command(Lm628Command::kLpes, limit);
}

// What is behind the outputs of a part.
enum class Lm628Converter : std::uint8_t { k12Bits, k8Bits, kNone };

// AN-693, "Initialization", after a reset. Returns false if the status is not one that it names.
inline bool initialise(Lm628Port& port, Lm628Converter converter) {
  const auto is_any = [](std::uint8_t value, std::uint8_t one, std::uint8_t other) {
    return value == one || value == other;
  };
  if (!is_any(port.status(), 0x84, 0xC4)) return false;
  if (converter == Lm628Converter::k12Bits) port.command(Lm628Command::kPort12);
  if (converter == Lm628Converter::k8Bits) port.command(Lm628Command::kPort8);
  port.command(Lm628Command::kRsti, 0x0000);
  while (!port.stuck()) {
    const std::uint8_t status = port.status();
    if ((status & lm628_status::kBusy) == 0) return is_any(status, 0x80, 0xC0);
  }
  return false;
}

}  // namespace trammel::sw
