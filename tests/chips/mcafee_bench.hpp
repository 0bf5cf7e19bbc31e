// SPDX-License-Identifier: Apache-2.0
//
// A processor, two encoders and a clock for mcafee_xy: its twin alone, or the RTL beside it with
// every pin compared at every evaluated clock, leaping with the clocks of sleeping domains off, or
// neither.
#pragma once

#include <Vmcafee_xy.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>

#include "cosim/cosim.hpp"
#include "models/exact/chips/mcafee_xy.hpp"
#include "rtl/chips/generated/mcafee_xy_regs.hpp"
#include "sw_nios/hal/lm628.hpp"
#include "tests/support/paced_master.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

namespace trammel::test {

namespace reg = mcafee_xy_regs;

class McafeeTwin {
 public:
  exact::McafeeXy::In in;

  McafeeTwin() {
    for (int i = 0; i < 6; ++i) twin_.step(in);
    twin_.reset();
  }

  const exact::McafeeXy& twin() const { return twin_; }
  void request(const cosim::BusOp& op, const AxiPace& = {}) {
    twin_.request(op.addr, op.data, op.write);
  }
  bool open() const { return twin_.open(); }  // a transfer

  // Runs up to n clocks, at least one.
  std::int64_t run(std::int64_t n) {
    const std::int64_t gap = std::min<std::int64_t>(twin_.next(in), n);
    pass(std::max<std::int64_t>(1, gap));
    return std::max<std::int64_t>(1, gap);
  }

 protected:
  void pass(std::int64_t gap) {
    if (twin_.next(in) >= gap) {
      twin_.advance(static_cast<exact::Gap>(gap));
    } else {
      twin_.step(in);
    }
  }

  exact::McafeeXy twin_;
};

// next_o of the RTL is below the twin's while its engines work: the twin waits for them.
class McafeePair : public McafeeTwin {
 public:
  bool leaps = true;

  McafeePair() {
    rtl_->leap_i = 0;
    bus_.reset(model());
    apply();
    rtl_->rst_i = 1;
    for (int i = 0; i < 4; ++i) rtl_.tick();
    rtl_.reset();
  }

  void request(const cosim::BusOp& op, const AxiPace& pace = {}) {
    op_ = op;
    bits_ = pace.bits();
    bus_.request(op.addr, op.data, op.write, pace);
    if (!op.write) read_ = op.addr;
  }
  bool open() const { return bus_.active(); }

  // The synchronisers have none: they see the pins at rest meanwhile.
  void reset() {
    bus_ = {};
    bus_.reset(model());
    cosim::enable_all_clocks(model());
    apply();
    rtl_->rst_i = 1;
    twin_.reset();
    for (int i = 0; i < 6; ++i) {
      rtl_.tick();
      twin_.step(in);
    }
    twin_.reset();
    rtl_->rst_i = 0;
    rtl_.eval();
    restless_ = 0;
  }

  std::int64_t run(std::int64_t n) {
    apply();
    const bool transfer = bus_.active();
    if (transfer && bus_.before_edge(model())) {
      twin_.request(op_.addr, op_.data, op_.write, bits_);
    }
    std::int64_t gap = 1;
    // A sample takes 400 clocks, a command 128: after them the RTL rests wherever the twin does.
    restless_ = !rtl_->quiescent_o && twin_.next(in) > 0 ? restless_ + 1 : 0;
    if (restless_ > 600) throw std::logic_error("the RTL does not rest" + after_clock(clock_));
    if (rtl_->quiescent_o) same("quiescent_o", 1, twin_.quiescent(in), clock_);
    if (leaps && rtl_->quiescent_o && rtl_->next_o > 0) {
      gap = std::min<std::int64_t>({rtl_->next_o, twin_.next(in), n});
      same("next_o", rtl_->next_o, std::min<exact::Gap>(twin_.next(in), 4095), clock_);
    }
    pass(gap);
    rtl_->leap_i = (gap - 1) & 0xFFF;
    cosim::enable_clocks(rtl_->clock_en_i, leaps ? unsigned{rtl_->awake_o} : ~0u);
    rtl_.tick();
    rtl_->leap_i = 0;
    clock_ += gap;
    if (transfer && bus_.after_edge(model())) same("open transfers", 0, twin_.open(), clock_);
    rtl_.eval();
    compare();
    return gap;
  }

 private:
  Vmcafee_xy& model() { return *rtl_.operator->(); }

  void apply() {
    rtl_->enc_a_i = in.enc_a_i;
    rtl_->enc_b_i = in.enc_b_i;
    rtl_->enc_idx_n_i = in.enc_idx_n_i;
    rtl_->limit_i = in.limit_i;
    rtl_.eval();
  }

  void compare() {
    const exact::Lm628Bridge::Out port = twin_.port();
    const auto both = [this](auto of) { return of(twin_.part(0)) | of(twin_.part(1)) << 1; };
    const auto pin = [this](const char* name, auto ours, auto theirs) {
      same(name, ours, theirs, clock_);
    };
    const exact::McafeeXy::Out out = twin_.out();
    pin("dac_x_o", rtl_->dac_x_o, out.dac_x_o);
    pin("dac_y_o", rtl_->dac_y_o, out.dac_y_o);
    pin("irq_o", rtl_->irq_o, twin_.irq());
    pin("hi_o", rtl_->hi_o, both([](const exact::Lm628& part) { return part.out().hi; }));
    pin("cs_x_n_o", rtl_->cs_x_n_o, port.cs_x_n);
    pin("cs_y_n_o", rtl_->cs_y_n_o, port.cs_y_n);
    pin("rd_n_o", rtl_->rd_n_o, port.rd_n);
    pin("wr_n_o", rtl_->wr_n_o, port.wr_n);
    pin("ps_o", rtl_->ps_o, port.ps);
    pin("d_o", rtl_->d_o, port.d);
    pin("transceiver_o", rtl_->transceiver_o, port.transceiver);
    pin("selector_o", rtl_->selector_o, port.selector);
    pin("d_oe_x_o", rtl_->d_oe_x_o, twin_.part(0).out().d_oe);
    pin("d_oe_y_o", rtl_->d_oe_y_o, twin_.part(1).out().d_oe);
    pin("sample_o", rtl_->sample_o, both([](const exact::Lm628& part) { return part.commits(); }));
    if (!bus_.active() && !twin_.open() && bus_.rdata() != twin_.read_data()) {
      const std::string name = register_name(reg::kRegisters, read_);
      same(name.c_str(), bus_.rdata(), twin_.read_data(), clock_);
    }
  }

  Rtl<Vmcafee_xy> rtl_;
  PacedMaster bus_;
  cosim::BusOp op_;
  std::uint32_t bits_ = ~0u;  // of the bytes it writes
  std::uint32_t read_ = 0;  // address of the last read
  std::int64_t clock_ = 0;
  int restless_ = 0;  // [clk]
};

// One part behind the port, at the addresses of its driver.
class McafeePart final : public sw::Bus {
 public:
  McafeePart(sw::Bus& bus, bool y) : bus_(bus), y_(y) {}

  std::uint32_t read(std::uint32_t address) override {
    access(address, reg::kPortBRead, reg::kPortBReadStrobe);
    return bus_.read(reg::kPortC);
  }
  void write(std::uint32_t address, std::uint32_t data) override {
    bus_.write(reg::kPortC, data);
    access(address, 0, reg::kPortBWriteStrobe);
  }

 private:
  void access(std::uint32_t address, std::uint32_t direction, std::uint32_t strobe) {
    const std::uint32_t pins = direction | (y_ ? reg::kPortBY : 0) |
                               (address == sw::lm628_map::kData ? reg::kPortBPs : 0);
    bus_.write(reg::kPortB, pins | strobe);
    bus_.write(reg::kPortB, pins);
    while ((bus_.read(reg::kStatus) & reg::kStatusBusy) != 0) {
    }
  }

  sw::Bus& bus_;
  bool y_;
};

template <class Chip>
class McafeeBench final : public sw::Bus {
 public:
  Chip chip;
  McafeePart part_x{*this, false}, part_y{*this, true};
  sw::Lm628Port x{part_x}, y{part_y};
  std::array<bool, 2> follows{};  // the motor is at its desired position from sample to sample
  std::function<void(std::int64_t)> watch;  // called with the clock after each run

  std::int64_t now() const { return now_; }  // [clk]
  std::int64_t samples(std::size_t axis) const { return samples_[axis]; }
  const exact::Lm628& part(std::size_t axis) const { return chip.twin().part(axis); }

  std::uint32_t read(std::uint32_t address) override {
    transfer({address, 0, false});
    return chip.twin().read_data();
  }
  void write(std::uint32_t address, std::uint32_t data) override {
    transfer({address, data, true});
  }

  void transfer(const cosim::BusOp& op, const AxiPace& pace = {}) {
    chip.request(op, pace);
    while (chip.open()) edge(1);
  }

  void clocks(std::int64_t n) {
    const std::int64_t end = now_ + n;
    while (now_ < end) edge(end - now_);
  }

  // Until the next sample of a part has been published.
  void sample(std::size_t axis = 0) {
    const std::int64_t before = samples_[axis];
    while (samples_[axis] == before) edge(100000);
  }

  void move_to(std::size_t axis, std::int64_t position, int clocks_a_count = 4) {
    while (position_[axis] != position) {
      position_[axis] += position > position_[axis] ? 1 : -1;
      const auto phase = static_cast<unsigned>(position_[axis] & 3);
      set_bit(chip.in.enc_a_i, axis, phase == 1 || phase == 2);
      set_bit(chip.in.enc_b_i, axis, phase >= 2);
      clocks(clocks_a_count);
    }
  }

  // RST of both parts, and the reset routine.
  void start() {
    write(reg::kReset, reg::kResetStrobe);
    clocks(80 + 66700);
  }

 private:
  void edge(std::int64_t limit) {
    const std::array<bool, 2> commits{part(0).commits(), part(1).commits()};
    now_ += chip.run(limit);
    if (watch) watch(now_);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!commits[axis]) continue;
      ++samples_[axis];
      if (follows[axis]) move_to(axis, part(axis).engine().desired().position >> 16);
    }
  }

  std::int64_t now_ = 0;
  std::array<std::int64_t, 2> samples_{}, position_{};
};

}  // namespace trammel::test
