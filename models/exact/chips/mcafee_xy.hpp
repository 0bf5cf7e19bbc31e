// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/chips/mcafee_xy.sv, clock by clock, with one bus transfer at a time. step() is one
// edge; while quiescent() holds, advance(n) passes n <= next() of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "models/exact/bus/lm628_bridge.hpp"
#include "models/exact/chips/lm628.hpp"
#include "models/exact/control/feed_rate.hpp"
#include "models/pins/port.hpp"
#include "rtl/chips/generated/mcafee_xy_regs.hpp"

namespace trammel::exact {

class McafeeXy {
 public:
  struct In {  // pins, bit 0 X, bit 1 Y; of limit_i X low, X high, Y low, Y high
    std::uint8_t enc_a_i = 0, enc_b_i = 0, enc_idx_n_i = 3, limit_i = 0;
  };
  struct Out {
    std::uint8_t dac_x_o = 0, dac_y_o = 0;
  };

  explicit McafeeXy(Lm628Clock clock = Lm628Clock::k6MHz) : parts_{Lm628(clock), Lm628(clock)} {}

  const Lm628& part(std::size_t axis) const { return parts_[axis]; }
  Lm628Bridge::Out port() const { return bridge_.out(); }
  Out out() const { return {dac(0), dac(1)}; }
  bool irq() const { return parts_[0].out().hi || parts_[1].out().hi; }

  // The synchronisers have no reset.
  void reset() {
    McafeeXy fresh;
    fresh.parts_ = parts_;
    for (Lm628& part : fresh.parts_) part.reset();
    fresh.limit_meta_ = limit_meta_;
    fresh.limit_ = limit_;
    *this = fresh;
  }

  // Valid from the present edge on; one at a time. A write is of these bits, whole bytes.
  void request(std::uint32_t address, std::uint32_t data, bool write, std::uint32_t bits = ~0u) {
    address_ = address;
    data_ = data;
    bits_ = bits;
    write_ = write;
    phase_ = 1;
  }
  bool open() const { return phase_ != 0; }
  std::uint32_t read_data() const { return read_data_; }

  void step(const In& in) {
    const Lm628Bridge::In host = bridge_in();
    const std::array<Lm628::In, 2> pins{part_in(in, 0), part_in(in, 1)};
    const bool refused = bridge_.refuses(host), sample = parts_[0].commits();
    const bool acts = phase_ == 2, strobe = std::exchange(reset_strobe_, false);
    if (acts && !write_) read_data_ = read(host);
    bridge_.step(host);
    for (std::size_t axis = 0; axis < 2; ++axis) parts_[axis].step(pins[axis]);
    reset_.step({strobe, kResetLow});
    step_feed();
    limit_ = limit_meta_;
    limit_meta_ = in.limit_i;
    if (acts && write_) write();
    if (refused) status_ |= mcafee_xy_regs::kStatusRefused;
    if (sample) status_ |= mcafee_xy_regs::kStatusSample;
    if (phase_ != 0) phase_ = phase_ == kEdges ? 0 : phase_ + 1;
  }

  bool quiescent(const In& in) const {
    return phase_ == 0 && bridge_.quiescent(bridge_in()) && parts_[0].quiescent(part_in(in, 0)) &&
           parts_[1].quiescent(part_in(in, 1)) && !feed_asked_ && feed_left_ == 0 &&
           in.limit_i == limit_meta_ && limit_meta_ == limit_;
  }

  Gap next(const In& in) const {
    if (!quiescent(in)) return 0;
    return std::min(
        {bridge_.next(), parts_[0].next(part_in(in, 0)), parts_[1].next(part_in(in, 1))});
  }

  void advance(Gap n) {
    bridge_.advance(n);
    for (Lm628& part : parts_) part.advance(n);
  }

 private:
  static constexpr int kEdges = 3;                // of a transfer: taken, acts, answered
  static constexpr std::uint32_t kResetLow = 80;  // [clk] of RST
  static constexpr int kFeed = 25;                // [clk] of the feed rate

  std::uint8_t dac(std::size_t axis) const {
    const Lm628Output::Out drive = parts_[axis].out().drive;
    return drive.dac_hi_lo ? drive.dac : 0x80;
  }

  Lm628Bridge::In bridge_in() const {
    using namespace mcafee_xy_regs;
    const auto bit = [this](std::uint32_t mask) { return (port_b_ & mask) != 0; };
    return {bit(kPortBWriteStrobe), bit(kPortBReadStrobe), bit(kPortBPs),       bit(kPortBRead),
            bit(kPortBY),           port_c_,               parts_[0].out().d, parts_[1].out().d};
  }

  Lm628::In part_in(const In& in, std::size_t axis) const {
    const Lm628Bridge::Out bus = bridge_.out();
    const bool cs_n = axis == 0 ? bus.cs_x_n : bus.cs_y_n;
    const auto pin = static_cast<int>(axis);
    return {{cs_n, bus.rd_n, bus.wr_n, bus.ps, bus.d},
            reset_.count() == 0,
            level(in.enc_a_i, pin),
            level(in.enc_b_i, pin),
            level(in.enc_idx_n_i, pin),
            false};
  }

  // A write while it computes is taken afterwards.
  void step_feed() {
    const bool starts = feed_asked_ && feed_left_ == 0;
    if (feed_left_ > 0) fed_ = --feed_left_ == 0;
    if (!starts) return;
    feed_asked_ = fed_ = false;
    feed_left_ = kFeed;
  }
  bool feed_ready() const { return fed_ && !feed_asked_; }

  void write() {
    using namespace mcafee_xy_regs;
    const std::uint32_t ones = data_ & bits_;
    const auto merge = [&](std::uint32_t old) { return (old & ~bits_) | ones; };
    switch (address_) {
      case kPortB: port_b_ = merge(port_b_) & 0x1F; break;
      case kPortC: port_c_ = static_cast<std::uint8_t>(merge(port_c_)); break;
      case kStatus: status_ &= ~ones; break;
      case kFeedIn:
        feed_in_ = merge(feed_in_) & 0xFFFF;
        feed_asked_ = feed_asked_ || (bits_ & kFeedInCMask) != 0;
        break;
      case kReset: reset_strobe_ = (ones & kResetStrobe) != 0; break;
      default: break;
    }
  }

  std::uint32_t read(const Lm628Bridge::In& host) const {
    using namespace mcafee_xy_regs;
    switch (address_) {
      case kId: return kIdValue;
      case kPortB: return port_b_;
      case kPortC: return bridge_.from_part();
      case kStatus: return status_ | (bridge_.busy(host) ? kStatusBusy : 0);
      case kFeedIn: return feed_in_;
      case kFeedOut: return feed_out();
      case kIrq:
        return (parts_[0].out().hi ? kIrqX : 0) | (parts_[1].out().hi ? kIrqY : 0);
      case kLimits: return limit_;
      default: return 0;
    }
  }

  std::uint32_t feed_out() const {
    if (!feed_ready()) return 0;
    const FeedRate::In in{static_cast<std::int32_t>(feed_in_ & 0xFF),
                          static_cast<std::int32_t>(feed_in_ >> 8)};
    return mcafee_xy_regs::kFeedOutReady | static_cast<std::uint32_t>(FeedRate().step(in).v);
  }

  std::array<Lm628, 2> parts_;
  Lm628Bridge bridge_;
  Timer reset_;
  std::uint32_t port_b_ = 0, feed_in_ = 0, status_ = 0;
  std::uint8_t port_c_ = 0;
  bool reset_strobe_ = false;
  bool feed_asked_ = false, fed_ = false;
  int feed_left_ = 0;  // [clk]
  std::uint8_t limit_meta_ = 0, limit_ = 0;
  std::uint32_t address_ = 0, data_ = 0, bits_ = ~0u, read_data_ = 0;
  bool write_ = false;
  int phase_ = 0;  // of the transfer
};

}  // namespace trammel::exact
