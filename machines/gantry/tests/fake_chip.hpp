// SPDX-License-Identifier: Apache-2.0
//
// The firmware of the gantry track on a bus that only remembers.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <deque>
#include <map>
#include <ostream>
#include <utility>
#include <vector>

#include "rtl/chips/generated/gantry_tau_regs.hpp"
#include "sw_nios/apps/gantry/gantry.hpp"
#include "sw_nios/hal/platform_map.hpp"

namespace trammel::gantry_test {

namespace regs = gantry_tau_regs;

struct Frame {
  std::uint32_t kind, channel, value;
  bool operator==(const Frame& o) const {
    return kind == o.kind && channel == o.channel && value == o.value;
  }
};
inline constexpr std::uint32_t kClearBit = 0, kSetBit = 1, kPollBit = 2, kPoll = 3, kValue = 4;

inline std::ostream& operator<<(std::ostream& to, const Frame& f) {
  return to << "kind " << f.kind << ", channel " << f.channel << ", value " << f.value;
}

// The chip as its firmware sees it: frames that wait, frames sent, and words.
struct FakeChip final : sw::Bus {
  std::map<std::uint32_t, std::uint32_t> words{{regs::kSendState, 40}, {regs::kSlots, 0x1'0002}};
  std::deque<Frame> waiting;
  std::vector<Frame> sent;
  std::vector<std::uint32_t> calibrated;
  std::map<std::uint32_t, int> writes;
  std::uint32_t later = 0;    // bits of STATUS that are set as the position is read
  std::uint32_t cleared = 0;  // of STATUS, last

  std::uint32_t read(std::uint32_t address) override {
    if (address == regs::kPosition) words[regs::kStatus] |= std::exchange(later, 0);
    if (address == regs::kReceive) {
      if (waiting.empty()) return 0;
      return regs::kReceiveWaits | waiting.front().kind << 8 | waiting.front().channel;
    }
    if (address == regs::kReceiveValue) return waiting.front().value;
    return words[address];
  }
  void write(std::uint32_t address, std::uint32_t data) override {
    ++writes[address];
    if (address == regs::kReceive) {
      REQUIRE(data == regs::kReceiveTake);
      waiting.pop_front();
    } else if (address == regs::kSend) {
      const std::uint32_t kind = data >> 8;
      sent.push_back({kind, data & 31, kind == kValue ? words[regs::kSendValue] : 0});
    } else if (address == regs::kCalibrate) {
      calibrated.push_back(data);
    } else if (address == regs::kStatus) {
      words[address] &= ~data;
      cleared = data;
    } else {
      words[address] = data;
    }
  }
};

struct Track {
  FakeChip chip;
  sw::GantryApp app;

  explicit Track(const sw::GantrySetup& setup = {}) : app(setup) {
    app.start(chip);
    chip.sent.clear();
    chip.writes.clear();
  }
  void interrupt(std::uint32_t status) {
    chip.words[sw::platform_map::kIrq] = sw::platform_map::kIrqChip;
    chip.words[regs::kStatus] = status;
    app.isr(chip);
  }
  std::vector<Frame> tell(std::vector<Frame> frames) {
    chip.sent.clear();
    chip.waiting.assign(frames.begin(), frames.end());
    interrupt(regs::kStatusFrame);
    return chip.sent;
  }
  // A control pass with the cart there [count], so many ticks behind the last one.
  void pass(std::int32_t count, std::uint32_t ticks = 9, bool known = true) {
    chip.words[regs::kTicks] += ticks;
    chip.words[regs::kAngle] = known ? regs::kAngleKnown : 0;
    chip.words[regs::kPosition] = static_cast<std::uint32_t>(count * 512);
    interrupt(regs::kStatusPass);
  }
  // Homing's rest of both motors at the stop.
  void release(std::int32_t count) { pass(count, 461); }
  std::int32_t force(std::uint32_t motor) {
    const std::uint32_t bits = chip.words[motor == 1 ? regs::kForce1 : regs::kForce2];
    return static_cast<std::int32_t>(bits ^ 0x400) - 0x400;
  }
};

}  // namespace trammel::gantry_test
