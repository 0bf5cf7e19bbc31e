// SPDX-License-Identifier: Apache-2.0
//
// A host, an encoder and a clock for the LM628: for its twin alone, or with a model beside it; for
// the RTL see lm628_pair.hpp.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <stdexcept>

#include "models/exact/chips/lm628.hpp"
#include "tests/support/lm628_commands.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

namespace trammel::test {

using exact::Lm628;
using exact::Opcode;

class Lm628Twin {
 public:
  Lm628::In in;

  explicit Lm628Twin(exact::Lm628Clock clock = exact::Lm628Clock::k8MHz) : twin_(clock) {
    for (int i = 0; i < 2; ++i) twin_.step(in);
    twin_.reset();
  }

  const Lm628& twin() const { return twin_; }

  // Runs up to n clocks, at least one, and not past the edge that publishes a sample.
  std::int64_t run(std::int64_t n) {
    const std::int64_t gap = std::min<std::int64_t>(twin_.next(in), n);
    if (gap == 0) {
      twin_.step(in);
      return 1;
    }
    twin_.advance(static_cast<exact::Gap>(gap));
    return gap;
  }

 protected:
  Lm628 twin_;
};

// Pins that the chip and its boards share.
template <class Model>
void set_pins(Rtl<Model>& rtl, const Lm628::In& in) {
  rtl->reset_n_i = in.reset_n;
  rtl->cs_n_i = in.host.cs_n;
  rtl->rd_n_i = in.host.rd_n;
  rtl->wr_n_i = in.host.wr_n;
  rtl->ps_i = in.host.ps;
  rtl->enc_a_i = in.a;
  rtl->enc_b_i = in.b;
  rtl->enc_idx_n_i = in.index_n;
}

template <class Model>
void same_pins(Rtl<Model>& rtl, const Lm628::Out& out, std::int64_t clock) {
  same("hi_o", rtl->hi_o, out.hi, clock);
  same("dac_o", rtl->dac_o, out.drive.dac, clock);
  same("dac_hi_lo_o", rtl->dac_hi_lo_o, out.drive.dac_hi_lo, clock);
  same("dac_wr_n_o", rtl->dac_wr_n_o, out.drive.dac_wr_n, clock);
  same("pwm_mag_o", rtl->pwm_mag_o, out.drive.pwm_mag, clock);
  same("pwm_sign_o", rtl->pwm_sign_o, out.drive.pwm_sign, clock);
}

template <class Chip>
class Lm628Bench : public Lm628Commands<Lm628Bench<Chip>> {
 public:
  Chip chip;

  std::int64_t now() const { return now_; }          // [clk]
  std::int64_t samples() const { return samples_; }  // published so far
  std::int64_t position() const { return position_; }
  const exact::Lm628Engine& engine() const { return chip.twin().engine(); }
  Lm628::Out out() const { return chip.twin().out(); }
  bool follows = false;  // the motor is at its desired position from sample to sample

  void clocks(std::int64_t n) {
    const std::int64_t end = now_ + n;
    while (now_ < end) edge(end - now_);
  }

  // Until the next sample has been published.
  void sample() {
    const std::int64_t before = samples_;
    while (samples_ == before) edge(100000);
    if (follows) move_to(engine().desired().position >> 16);
  }
  void sample(int n) {
    for (int i = 0; i < n; ++i) sample();
  }

  // The encoder, a count every few clocks.
  void move_to(std::int64_t position, int clocks_a_count = 3) {
    while (position_ != position) {
      position_ += position > position_ ? 1 : -1;
      set_lines();
      clocks(clocks_a_count);
    }
  }
  void set_index(std::int64_t count) {
    index_ = count;
    has_index_ = true;
    set_lines();
  }

  void hardware_reset(int low) {
    chip.in.reset_n = false;
    clocks(low);
    chip.in.reset_n = true;
    clocks(4);
  }
  void start() {
    hardware_reset(60);
    clocks(50010);
  }

  // Host port, its times those of the data sheet or a little more.
  void write(bool ps, std::uint8_t value) {
    auto& host = chip.in.host;
    host.ps = ps;
    host.cs_n = false;
    host.d = value;
    clocks(2);
    host.wr_n = false;
    clocks(5);
    host.wr_n = true;
    clocks(6);
    host.cs_n = true;
    clocks(1);
  }
  std::uint8_t read(bool ps) {
    auto& host = chip.in.host;
    host.ps = ps;
    host.cs_n = false;
    clocks(2);
    host.rd_n = false;
    clocks(9);
    if (!out().d_oe) throw std::logic_error("no data on the bus" + after_clock(now_));
    const std::uint8_t value = out().d;
    host.rd_n = true;
    host.cs_n = true;
    clocks(9);
    if (out().d_oe) throw std::logic_error("data on the bus still" + after_clock(now_));
    return value;
  }

 private:
  void edge(std::int64_t limit) {
    const bool commits = chip.twin().commits();
    now_ += chip.run(limit);
    if (commits) ++samples_;
  }

  void set_lines() {
    const auto phase = static_cast<unsigned>(position_ & 3);
    chip.in.a = phase == 1 || phase == 2;
    chip.in.b = phase >= 2;
    chip.in.index_n = !(has_index_ && position_ == index_);
  }

  std::int64_t now_ = 0, samples_ = 0, position_ = 0, index_ = 0;
  bool has_index_ = false;
};

}  // namespace trammel::test
