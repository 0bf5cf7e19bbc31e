// SPDX-License-Identifier: Apache-2.0
//
// mcafee_xy of its bit-exact twin behind the Chip interface; only clocks in which something happens
// are stepped.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <memory>
#include <string>

#include "cosim/host_timer.hpp"
#include "cosim/mcafee/chip.hpp"
#include "models/exact/chips/mcafee_xy.hpp"
#include "sw_nios/hal/mcafee_map.hpp"

namespace trammel::mcafee {

class TwinChip final : public McafeeChip {
 public:
  bool logs = false;
  std::string bytes;  // that passed the port: c 1F, d 00 to X, C and D to Y; r, R data read

  TwinChip() {
    for (int i = 0; i < 4; ++i) chip_.step(in_);
    chip_.reset();
  }

  const exact::Lm628& part(int axis) const { return chip_.part(static_cast<std::size_t>(axis)); }
  // That the last sample took [count].
  std::int64_t target(int axis) const { return targets_[static_cast<std::size_t>(axis)]; }

  lm628::Words words(int axis) const override {
    const exact::Lm628Engine& engine = part(axis).engine();
    lm628::Words w;
    w.position = engine.desired().position;
    w.speed = static_cast<std::int32_t>(engine.desired().speed);
    w.actual = static_cast<std::int32_t>(engine.actual());
    w.error = static_cast<std::int32_t>(engine.error());
    w.proportional = static_cast<std::int32_t>(engine.filter().kp * engine.error());
    w.integral = static_cast<std::int32_t>(engine.pid().integral(engine.filter()));
    w.derivative = static_cast<std::int32_t>(engine.pid().derivative());
    w.output = static_cast<std::int32_t>(engine.output());
    w.status = part(axis).status();
    return w;
  }
  bool host_irq(int axis) const override { return part(axis).out().hi; }
  cosim::Clk evaluated() const override { return evaluated_; }

  cosim::Clk now() const override { return now_; }
  cosim::Lines drive() const override { return drive_; }
  bool irq() const override { return irq_; }
  std::uint32_t rdata() const override { return rdata_; }

  void request(const cosim::BusOp& op) override {
    op_ = op;
    open_ = true;
    if (!to_platform()) chip_.request(op.addr, op.data, op.write);
  }

  void sense(cosim::Lines lines) override {
    const auto bit = [lines](int n) { return (lines >> n & 1) != 0; };
    in_.limits = 0;
    for (int axis = 0; axis < kAxes; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      in_.a[k] = bit(encoder_a(axis));
      in_.b[k] = bit(encoder_b(axis));
      in_.index_n[k] = !bit(marker(axis));
      in_.limits = static_cast<std::uint8_t>(in_.limits |
                                             (bit(limit_low(axis)) ? 1u : 0u) << 2 * axis |
                                             (bit(limit_high(axis)) ? 2u : 0u) << 2 * axis);
    }
  }

  cosim::Stop run(cosim::Clk end, const cosim::Plant&) override {
    while (now_ < end) {
      const cosim::Clk edge = now_;
      const cosim::Clk gap =
          open_ ? 0 : std::min({cosim::Clk{chip_.next(in_)}, end - edge, timer_.waiting(edge)});
      if (gap > 1) {
        chip_.advance(static_cast<exact::Gap>(gap - 1));
        now_ += gap - 1;
        continue;
      }
      const unsigned why = step(edge);
      if (why != 0) return {edge, why};
    }
    return {now_ - 1, cosim::kLimit};
  }

 private:
  bool to_platform() const { return op_.addr >= sw::mcafee_map::kTimer; }

  unsigned step(cosim::Clk edge) {
    unsigned why = part(0).commits() ? cosim::kSample : 0u;
    for (int axis = 0; axis < kAxes; ++axis) {
      if (!part(axis).samples()) continue;
      targets_[static_cast<std::size_t>(axis)] = part(axis).engine().desired().target;
    }
    const exact::Lm628Bridge::Out before = chip_.port();
    chip_.step(in_);
    ++now_;
    ++evaluated_;
    if (logs) log(before, chip_.port());
    timer_.pass(edge);
    if (open_ && (to_platform() || !chip_.open())) {
      open_ = false;
      if (to_platform()) platform(edge);
      if (!to_platform()) rdata_ = chip_.read_data();
      why |= cosim::kBusDone;
    }
    return why | changed_outputs();
  }

  void platform(cosim::Clk edge) {
    namespace map = sw::mcafee_map;
    if (op_.write && op_.addr == map::kTimer) timer_.write(edge, op_.data);
    if (op_.write) return;
    rdata_ = op_.addr == map::kIrq ? (chip_.irq() ? map::kIrqHost : 0u) |
                                         (timer_.irq() ? map::kIrqTimer : 0u)
                                   : 0u;
  }

  unsigned changed_outputs() {
    const cosim::Lines drive = cosim::Lines{chip_.dac(0)} << converter(0) |
                               cosim::Lines{chip_.dac(1)} << converter(1);
    const bool irq = chip_.irq() || timer_.irq();
    const unsigned why = (drive != drive_ ? cosim::kDrive : 0u) |
                         (irq && !irq_ ? cosim::kIrq : 0u);
    drive_ = drive;
    irq_ = irq;
    return why;
  }

  // At the end of a strobe.
  void log(const exact::Lm628Bridge::Out& was, const exact::Lm628Bridge::Out& is) {
    const bool wrote = !was.wr_n && is.wr_n, read = !was.rd_n && is.rd_n && was.ps;
    if (!wrote && !read) return;
    const int axis = was.cs_x_n ? 1 : 0;
    const char kind = read ? 'r' : was.ps ? 'd' : 'c';
    const unsigned byte = read ? part(axis).out().d : was.d;
    constexpr const char* kDigits = "0123456789ABCDEF";
    bytes += {axis == 1 ? static_cast<char>(std::toupper(kind)) : kind, kDigits[byte >> 4],
              kDigits[byte & 15], ' '};
  }

  exact::McafeeXy chip_;
  exact::McafeeXy::In in_;
  cosim::HostTimer timer_;
  cosim::BusOp op_;
  bool open_ = false;  // a transfer
  cosim::Clk now_ = 0, evaluated_ = 0;
  std::uint32_t rdata_ = 0;
  bool irq_ = false;
  cosim::Lines drive_ = kZeroCode << converter(0) | kZeroCode << converter(1);
  std::array<std::int64_t, 2> targets_{};
};

std::unique_ptr<McafeeChip> make_twin_chip();

}  // namespace trammel::mcafee
