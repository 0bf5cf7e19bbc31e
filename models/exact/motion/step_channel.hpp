// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/motion/step_channel.sv.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "models/exact/math/timer.hpp"
#include "models/exact/motion/step_clock.hpp"

namespace trammel::exact {

// Bits of the status word above the rate.
inline constexpr std::uint32_t kStepRate = 0xFFF;
inline constexpr std::uint32_t kStepBusy = 1u << 12;
inline constexpr std::uint32_t kStepForward = 1u << 13;
inline constexpr std::uint32_t kStepReset = 1u << 14;  // read: a switch is closed
inline constexpr std::uint32_t kStepEnable = 1u << 15;
inline constexpr std::uint32_t kStepTerminal = 0xFFFF;

class StepChannel {
 public:
  struct Pins {
    bool low = false, high = false;  // limit switches
    bool buf_busy = false;
  };
  struct In {
    Pins pins;
    std::optional<std::uint16_t> count, status;  // that are written
    bool grant = false;
  };
  struct Out {
    bool step = false, forward = false, flush = false, irq = false;
    std::uint16_t count = kStepTerminal, status = 0;
  };

  explicit StepChannel(bool buffered = true) : buffered_(buffered) {}

  // The synchronisers have no reset.
  void reset() {
    StepChannel fresh(buffered_);
    fresh.meta_ = meta_;
    fresh.seen_ = seen_;
    *this = fresh;
  }

  Out out() const {
    const std::uint32_t status = rate_ | (busy_ ? kStepBusy : 0) | (forward_ ? kStepForward : 0) |
                                 (seen_.low || seen_.high ? kStepReset : 0) |
                                 (enable_ ? kStepEnable : 0);
    return {step_, forward_, latch_, done_ && enable_, count_, static_cast<std::uint16_t>(status)};
  }

  // One edge; of the clock, what it showed before.
  void step(const In& in, const StepClock::Out& clock) {
    const bool tripped = trip(), over = clock.tick && moving() && divider_ == kStepRate;
    const bool at_end = ended();
    if (over) {
      divider_ = rate_;
    } else if (moving()) {
      divider_ = (divider_ + (clock.tick ? 1u : 0u)) & kStepRate;
    }
    if (clock.half) step_ = false;
    if (in.grant) done_ = false;
    if (tripped) {
      busy_ = false;
      latch_ = done_ = true;
    } else if (over) {
      ++count_;
      step_ = true;
    } else if (at_end) {
      busy_ = false;
      done_ = true;
    }
    if (in.count) count_ = *in.count;
    if (in.status) write(*in.status);
    seen_ = meta_;
    meta_ = used(in.pins);
  }

  bool quiescent(const In& in) const {
    return !trip() && !ended() && !in.count && !in.status && !(in.grant && done_) &&
           same(used(in.pins), meta_) && same(meta_, seen_);
  }

  Gap next(const StepClock& clock) const {
    const StepClock::Out now = clock.out();
    Gap gap = kGapMax;
    if (moving()) {
      gap = std::min((kStepRate - divider_) * clock.tick_clk() + now.next_tick, kGapMax - 1);
    }
    return step_ ? std::min(gap, now.next_half) : gap;
  }

  void advance(Gap ticks) {
    if (moving()) divider_ = (divider_ + ticks) & kStepRate;
  }

 private:
  bool moving() const { return busy_ && count_ != kStepTerminal; }
  bool trip() const { return busy_ && (forward_ ? seen_.high : seen_.low); }
  bool ended() const { return busy_ && !moving() && !step_ && !seen_.buf_busy; }

  Pins used(const Pins& pins) const { return {pins.low, pins.high, buffered_ && pins.buf_busy}; }
  static bool same(const Pins& a, const Pins& b) {
    return a.low == b.low && a.high == b.high && a.buf_busy == b.buf_busy;
  }

  void write(std::uint32_t status) {
    rate_ = status & kStepRate;
    forward_ = (status & kStepForward) != 0;
    enable_ = (status & kStepEnable) != 0;
    if ((status & kStepReset) != 0) {
      divider_ = 0;
      busy_ = latch_ = done_ = false;
    }
    if ((status & kStepBusy) == 0) {
      busy_ = false;
    } else if (!busy_ && !latch_) {
      divider_ = rate_;
      busy_ = count_ != kStepTerminal;
      done_ = !busy_;
    }
  }

  bool buffered_;
  std::uint32_t rate_ = 0, divider_ = 0;
  std::uint16_t count_ = kStepTerminal;
  bool forward_ = false, enable_ = false, busy_ = false, latch_ = false, done_ = false;
  bool step_ = false;
  Pins meta_, seen_;
};

}  // namespace trammel::exact
