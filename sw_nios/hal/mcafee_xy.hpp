// SPDX-License-Identifier: Apache-2.0
//
// Driver of McAfee's port picture (1994, ch. VI, canonical bits of his Stage I): a byte goes to or
// comes from one of two LM628 by port C, and port B says which, how, and when. Each rising strobe
// starts one pulse; nothing of the port may move before it has ended. Freestanding.
#pragma once

#include <cstdint>

#include "sw_nios/hal/bus.hpp"
#include "sw_nios/hal/lm628.hpp"

namespace trammel::sw {

// Registers of the chip, and behind it those of the platform.
namespace mcafee_map {
inline constexpr std::uint32_t kPortB = 0x04;
inline constexpr std::uint32_t kWriteStrobe = 1u << 0;
inline constexpr std::uint32_t kReadStrobe = 1u << 1;
inline constexpr std::uint32_t kDataPort = 1u << 2;  // pin PS
inline constexpr std::uint32_t kReads = 1u << 3;
inline constexpr std::uint32_t kSelectY = 1u << 4;
inline constexpr std::uint32_t kPortC = 0x08;
inline constexpr std::uint32_t kStatus = 0x0C;
inline constexpr std::uint32_t kBusy = 1u << 0;
inline constexpr std::uint32_t kSample = 1u << 2;  // a sample was published; writing 1 clears it
inline constexpr std::uint32_t kFeedIn = 0x10;     // c, and cc from bit 8 on
inline constexpr std::uint32_t kFeedOut = 0x14;    // v
inline constexpr std::uint32_t kFeedReady = 1u << 31;
inline constexpr std::uint32_t kIrq = 0x18;     // pins HI: bit 0 of X, bit 1 of Y
inline constexpr std::uint32_t kLimits = 0x1C;  // X low, X high, Y low, Y high
inline constexpr std::uint32_t kReset = 0x20;   // 1 strobes RST of both parts
inline constexpr std::uint32_t kTimer = 0x100;  // [clk] until it interrupts, once; 0 = off
inline constexpr std::uint32_t kTimerIrq = 0x104;
}  // namespace mcafee_map

// One of the two parts as the bus that Lm628Port speaks to.
class McafeePart final : public Bus {
 public:
  // A pulse lasts 5.5 us, a poll more than 0.1 us.
  static constexpr std::uint32_t kPollLimit = 256;

  McafeePart(Bus& bus, bool y) : bus_(bus), axis_(y ? mcafee_map::kSelectY : 0) {}

  std::uint32_t read(std::uint32_t addr) override {
    pulse(addr, mcafee_map::kReads, mcafee_map::kReadStrobe);
    return bus_.read(mcafee_map::kPortC) & 0xFF;
  }

  void write(std::uint32_t addr, std::uint32_t data) override {
    bus_.write(mcafee_map::kPortC, data);
    pulse(addr, 0, mcafee_map::kWriteStrobe);
  }

 private:
  void pulse(std::uint32_t addr, std::uint32_t direction, std::uint32_t strobe) {
    const std::uint32_t ps = addr == lm628_map::kData ? mcafee_map::kDataPort : 0;
    const std::uint32_t selected = axis_ | ps | direction;
    bus_.write(mcafee_map::kPortB, selected);
    bus_.write(mcafee_map::kPortB, selected | strobe);
    for (std::uint32_t polls = 0; polls < kPollLimit; ++polls) {
      if ((bus_.read(mcafee_map::kStatus) & mcafee_map::kBusy) == 0) return;
    }
  }

  Bus& bus_;
  std::uint32_t axis_;
};

}  // namespace trammel::sw
