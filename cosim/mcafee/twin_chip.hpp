// SPDX-License-Identifier: Apache-2.0
//
// McAfee's machine of bit-exact twins: the port picture in front of two LM628 and the feed rate,
// with the platform's timer. Its bus transfers take a constant time.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <string>

#include "cosim/mcafee/chip.hpp"
#include "models/exact/chips/lm628.hpp"
#include "models/exact/control/feed_rate.hpp"
#include "sw_nios/hal/mcafee_xy.hpp"

namespace trammel::mcafee {

class TwinChip final : public McafeeChip {
 public:
  static constexpr cosim::Clk kPulse = 275;  // 5.5 us

  std::string bytes;  // that passed the port: c 1F, d 00 to X, C and D to Y; r, R data read
  bool logs = false;

  TwinChip() {
    for (auto& part : parts_) {
      for (int i = 0; i < 2; ++i) part.step({});
      part.reset();
    }
  }

  const exact::Lm628& part(std::size_t k) const { return parts_[k]; }
  std::int64_t target(std::size_t k) const { return targets_[k]; }  // that the last sample took

  Words words(std::size_t axis) const override {
    const exact::Lm628Engine& engine = parts_[axis].engine();
    return {engine.desired().position, static_cast<std::int32_t>(engine.desired().speed),
            static_cast<std::int32_t>(engine.actual()), static_cast<std::int32_t>(engine.error()),
            static_cast<std::int32_t>(engine.output())};
  }
  cosim::Clk evaluated() const override { return evaluated_; }

  cosim::Clk now() const override { return now_; }
  cosim::Lines drive() const override { return drive_; }
  bool irq() const override { return irq_; }
  std::uint32_t rdata() const override { return rdata_; }
  void request(const cosim::BusOp& op) override {
    op_ = op;
    bus_end_ = now_ + kTransfer - 1;
  }

  void sense(cosim::Lines lines) override {
    for (std::size_t k = 0; k < 2; ++k) {
      in_[k].a = (lines >> encoder_a(k) & 1) != 0;
      in_[k].b = (lines >> encoder_b(k) & 1) != 0;
      in_[k].index_n = (lines >> index_n(k) & 1) != 0;
    }
    limits_ = static_cast<std::uint32_t>(lines >> kLimits & 0xF);
  }

  cosim::Stop run(cosim::Clk end, const cosim::Plant&) override {
    while (now_ < end) {
      const cosim::Clk edge = now_;
      set_pins();
      const bool commits = parts_[0].commits();
      const cosim::Clk own = std::min({end, bus_end_, timer_, pulse_change()}) - edge;
      const std::int64_t gap = std::min<std::int64_t>(
          {own, parts_[0].next(in_[0]), parts_[1].next(in_[1])});
      if (gap > 0) {
        for (auto& part : parts_) part.advance(static_cast<exact::Gap>(gap));
        now_ += gap;
        continue;
      }
      for (std::size_t k = 0; k < 2; ++k) {
        if (parts_[k].samples()) targets_[k] = parts_[k].engine().desired().target;
        parts_[k].step(in_[k]);
      }
      ++now_;
      ++evaluated_;
      unsigned why = commits ? cosim::kSample : 0u;
      sampled_ = sampled_ || commits;
      if (edge == pulse_begin_ + kSetup + kPulse - 1 && reads()) {
        byte_ = parts_[selected()].out().d;
        if ((port_b_ & sw::mcafee_map::kDataPort) != 0) log('r', byte_);
      }
      if (edge == timer_) {
        timer_ = cosim::kNever;
        timer_irq_ = true;
      }
      if (edge == bus_end_) {
        bus_end_ = cosim::kNever;
        transfer(edge);
        why |= cosim::kBusDone;
      }
      why |= changed_outputs();
      if (why != 0) return {edge, why};
    }
    return {now_ - 1, cosim::kLimit};
  }

 private:
  static constexpr cosim::Clk kTransfer = 4;  // [clk] of the bus
  static constexpr cosim::Clk kSetup = 3;
  static constexpr cosim::Clk kHold = 10;
  static constexpr cosim::Clk kResetLow = 80;

  bool reads() const { return (port_b_ & sw::mcafee_map::kReads) != 0; }
  std::size_t selected() const { return (port_b_ & sw::mcafee_map::kSelectY) != 0 ? 1 : 0; }
  bool busy() const { return now_ < pulse_begin_ + kSetup + kPulse + kHold; }

  // The next edge at which a pin of the port moves, or this one.
  cosim::Clk pulse_change() const {
    const cosim::Clk high = pulse_begin_ + kSetup + kPulse;
    for (const cosim::Clk at :
         {pulse_begin_, pulse_begin_ + kSetup, high - 1, high, high + kHold, reset_end_}) {
      if (at >= now_) return at;
    }
    return cosim::kNever;
  }

  void set_pins() {
    for (std::size_t k = 0; k < 2; ++k) {
      exact::Lm628Port::Pins pins;
      const cosim::Clk phase = now_ - pulse_begin_ - kSetup;
      const bool low = busy() && phase >= 0 && phase < kPulse;
      if (busy() && k == selected()) {
        pins.cs_n = false;
        pins.ps = (port_b_ & sw::mcafee_map::kDataPort) != 0;
        pins.wr_n = reads() || !low;
        pins.rd_n = !reads() || !low;
        pins.d = port_c_;
      }
      in_[k].host = pins;
      in_[k].reset_n = now_ >= reset_end_;
    }
  }

  void transfer(cosim::Clk edge) {
    namespace map = sw::mcafee_map;
    if (!op_.write) {
      rdata_ = value(op_.addr);
      return;
    }
    switch (op_.addr) {
      case map::kPortB: {
        const std::uint32_t rises = op_.data & ~port_b_ & (map::kWriteStrobe | map::kReadStrobe);
        port_b_ = op_.data;
        if (rises == 0) break;
        pulse_begin_ = edge + 1;
        if (reads()) break;
        log((port_b_ & map::kDataPort) != 0 ? 'd' : 'c', port_c_);
        break;
      }
      case map::kPortC: port_c_ = static_cast<std::uint8_t>(op_.data); break;
      case map::kStatus: sampled_ = sampled_ && (op_.data & map::kSample) == 0; break;
      case map::kFeedIn:
        feed_ = feed_rate_.step({static_cast<std::int32_t>(op_.data & 0xFF),
                                 static_cast<std::int32_t>(op_.data >> 8 & 0xFF)}).v;
        break;
      case map::kReset: reset_end_ = edge + kResetLow; break;
      case map::kTimer:
        timer_ = op_.data == 0 ? cosim::kNever : edge + op_.data;
        timer_irq_ = false;
        break;
      default: break;
    }
  }

  std::uint32_t value(std::uint32_t addr) const {
    namespace map = sw::mcafee_map;
    switch (addr) {
      case map::kPortC: return byte_;
      case map::kStatus: return (busy() ? map::kBusy : 0) | (sampled_ ? map::kSample : 0);
      case map::kFeedOut: return static_cast<std::uint32_t>(feed_) | map::kFeedReady;
      case map::kIrq: return (parts_[0].out().hi ? 1u : 0) | (parts_[1].out().hi ? 2u : 0);
      case map::kLimits: return limits_;
      case map::kTimerIrq: return timer_irq_ ? 1 : 0;
      default: return 0;
    }
  }

  void log(char kind, unsigned byte) {
    if (!logs) return;
    constexpr const char* kDigits = "0123456789ABCDEF";
    if (selected() == 1) kind = static_cast<char>(std::toupper(kind));
    bytes += {kind, kDigits[byte >> 4], kDigits[byte & 15], ' '};
  }

  unsigned changed_outputs() {
    unsigned why = 0;
    const cosim::Lines codes = parts_[0].out().drive.dac |
                               cosim::Lines{parts_[1].out().drive.dac} << 8;
    if (codes != drive_) why |= cosim::kDrive;
    drive_ = codes;
    const bool irq = parts_[0].out().hi || parts_[1].out().hi || timer_irq_;
    if (irq && !irq_) why |= cosim::kIrq;
    irq_ = irq;
    return why;
  }

  std::array<exact::Lm628, 2> parts_{exact::Lm628(exact::Lm628Clock::k6MHz),
                                     exact::Lm628(exact::Lm628Clock::k6MHz)};
  std::array<exact::Lm628::In, 2> in_;
  exact::FeedRate feed_rate_;
  cosim::BusOp op_;
  cosim::Clk now_ = 0, evaluated_ = 0;
  cosim::Clk bus_end_ = cosim::kNever, timer_ = cosim::kNever;
  cosim::Clk pulse_begin_ = -1000, reset_end_ = -1000;
  std::uint32_t port_b_ = 0, limits_ = 0, rdata_ = 0;
  std::uint8_t port_c_ = 0, byte_ = 0;
  std::int32_t feed_ = 0;
  bool sampled_ = false, timer_irq_ = false, irq_ = false;
  cosim::Lines drive_ = kZeroCodes;
  std::array<std::int64_t, 2> targets_{};
};

}  // namespace trammel::mcafee
