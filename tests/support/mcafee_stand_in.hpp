// SPDX-License-Identifier: Apache-2.0
//
// McAfee's machine without its RTL: the port picture in front of the twins of two LM628 and of the
// feed rate, with the platform's timer; and what the parts can drive.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <string>

#include "cosim/cosim.hpp"
#include "models/exact/chips/lm628.hpp"
#include "models/exact/control/feed_rate.hpp"
#include "models/plant/xy_stage.hpp"
#include "sw_nios/hal/mcafee_xy.hpp"

namespace trammel::test {

// Bits of sense() of axis k; drive() holds the codes of the converters, X in the low byte.
constexpr int encoder_a(std::size_t k) { return static_cast<int>(3 * k); }
constexpr int encoder_b(std::size_t k) { return static_cast<int>(3 * k + 1); }
constexpr int index_n(std::size_t k) { return static_cast<int>(3 * k + 2); }
inline constexpr int kLimitLines = 6;
constexpr unsigned code_of(cosim::Lines drive, std::size_t k) {
  return static_cast<unsigned>(drive >> 8 * k & 0xFF);
}

class McafeeStandIn final : public cosim::Chip {
 public:
  static constexpr cosim::Clk kPulse = 275;  // 5.5 us

  std::string bytes;  // that passed the port: c 1F, d 00 to X, C and D to Y; r, R data read
  bool logs = false;

  McafeeStandIn() {
    for (auto& part : parts_) {
      for (int i = 0; i < 2; ++i) part.step({});
      part.reset();
    }
  }

  const exact::Lm628& part(std::size_t k) const { return parts_[k]; }
  std::int64_t target(std::size_t k) const { return targets_[k]; }  // that the last sample took

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
    limits_ = static_cast<std::uint32_t>(lines >> kLimitLines & 0xF);
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
  cosim::Clk now_ = 0, bus_end_ = cosim::kNever, timer_ = cosim::kNever;
  cosim::Clk pulse_begin_ = -1000, reset_end_ = -1000;
  std::uint32_t port_b_ = 0, limits_ = 0, rdata_ = 0;
  std::uint8_t port_c_ = 0, byte_ = 0;
  std::int32_t feed_ = 0;
  bool sampled_ = false, timer_irq_ = false, irq_ = false;
  cosim::Lines drive_ = 0x8080;
  std::array<std::int64_t, 2> targets_{};
};

// Encoder lines of a count, marker high.
constexpr cosim::Lines count_lines(std::int64_t count, std::size_t k) {
  return cosim::Lines{((count + 1) & 2) != 0} << encoder_a(k) |
         cosim::Lines{(count & 2) != 0} << encoder_b(k) | cosim::Lines{1} << index_n(k);
}

// Motors that are where they are told to be, from sample to sample.
class XyFollower final : public cosim::Plant, public cosim::Observer {
 public:
  explicit XyFollower(const McafeeStandIn& chip) : chip_(chip) {}

  // Goes there with the first sample, and stays.
  void hold(std::array<std::int64_t, 2> counts) {
    hold_ = counts;
    held_ = true;
  }
  void limit_at(std::int64_t count) { limit_ = count; }  // of X

  cosim::Lines sense() const override {
    return count_lines(count_[0], 0) | count_lines(count_[1], 1) |
           cosim::Lines{count_[0] >= limit_} << (kLimitLines + 1);
  }
  cosim::Clk next() const override { return count_ == goal_ ? cosim::kNever : at_ + 4; }
  void commit(cosim::Clk n, cosim::Lines) override {
    if (n < next()) return;
    for (std::size_t k = 0; k < 2; ++k) {
      if (count_[k] != goal_[k]) count_[k] += goal_[k] > count_[k] ? 1 : -1;
    }
    at_ = n;
  }
  int sample(int, cosim::Clk) const override { return 0; }
  void on(const cosim::Stop& stop, const cosim::Chip&, const cosim::Plant&) override {
    if ((stop.why & cosim::kSample) == 0) return;
    for (std::size_t k = 0; k < 2; ++k) {
      goal_[k] = held_ ? hold_[k] : chip_.part(k).engine().desired().position >> 16;
    }
    at_ = stop.edge;
  }

 private:
  const McafeeStandIn& chip_;
  std::array<std::int64_t, 2> count_{}, goal_{}, hold_{};
  cosim::Clk at_ = 0;
  bool held_ = false;
  std::int64_t limit_ = 1 << 30;
};

// The stage of models/ behind the interface of cosim/.
class StagePlant final : public cosim::Plant {
 public:
  explicit StagePlant(const plant::XyStageConfig& config) : stage_(config) {}

  const plant::XyStage& stage() const { return stage_; }

  cosim::Lines sense() const override {
    cosim::Lines lines = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const plant::LeadscrewSensor& s = stage_.axis(k).sensor();
      lines |= cosim::Lines{s.encoder().a()} << encoder_a(k) |
               cosim::Lines{s.encoder().b()} << encoder_b(k) |
               cosim::Lines{s.encoder().marker()} << index_n(k) |
               (cosim::Lines{s.at_low()} | cosim::Lines{s.at_high()} << 1) << (kLimitLines + 2 * k);
    }
    return lines;
  }
  cosim::Clk next() const override { return stage_.next(); }
  void commit(cosim::Clk n, cosim::Lines drive) override {
    stage_.commit(n, {code_of(drive, 0), code_of(drive, 1)});
  }
  int sample(int, cosim::Clk) const override { return 0; }

 private:
  plant::XyStage stage_;
};

}  // namespace trammel::test
