// SPDX-License-Identifier: Apache-2.0
//
// An LM628 behind a bus wrapper, and beside it one at the bare port, whose host is
// parts/lm628/host_port.hpp: the same accesses at the same clocks. Every pin of the two parts is
// compared in every clock, and that each access was asked for, once and in the order of its
// direction.
//
// The master of the wrapper derives from it: it sets the bus and says what it expects.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <deque>
#include <stdexcept>

#include "models/exact/chips/lm628.hpp"
#include "parts/lm628/host_port.hpp"
#include "tests/support/lm628_commands.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

namespace trammel::test {

template <class Model>
class Wrapped {
 public:
  explicit Wrapped(std::uint32_t seed) : random(seed) {}
  virtual ~Wrapped() = default;

  Rtl<Model> rtl;
  Random random;

  std::int64_t now() const { return clock_; }
  int accesses() const { return accesses_; }
  bool all_done() const { return writes_.empty() && reads_.empty() && !port_.active(); }
  std::uint8_t given() const { return given_; }  // by the bare part, to the last read
  const exact::Lm628& part() const { return part_; }
  bool hi() const { return hi_; }  // pin HI two clocks ago

  // Of the wrapper's master: an access that is to come.
  void expect(bool write, bool ps, std::uint8_t byte) {
    (write ? writes_ : reads_).push_back({ps ? kData : kCommand, byte, write});
  }

  // RST of both parts, and their reset routine.
  void start() {
    rtl.reset();
    for (int i = 0; i < 60; ++i) edge(false);
    pass(50'010);
  }

  void edge(bool reset_n = true) {
    rtl->d_i = part_.out().d_oe ? part_.out().d : random() & 0xFF;
    rtl->hi_i = part_.out().hi;
    rtl.eval();
    if (rtl->drive_o && part_.out().d_oe) {
      throw std::logic_error("both drive" + after_clock(clock_));
    }
    exact::Lm628::In in, bare;
    const auto wire = static_cast<std::uint8_t>(rtl->drive_o ? rtl->d_o : random() & 0xFF);
    in.host = {rtl->cs_n_o != 0, rtl->rd_n_o != 0, rtl->wr_n_o != 0, rtl->ps_o != 0, wire};
    const bool quiescent = bus_idle() && !port_.active() && part_.out().hi == hi_meta_ &&
                           hi_meta_ == hi_;
    if (clock_ > 3) same("quiescent_o", rtl->quiescent_o, quiescent, clock_);
    const lm628::HostPins pins = port_.pins();
    bare.host = {pins.cs_n, pins.rd_n, pins.wr_n, pins.ps, pins.d};
    in.reset_n = bare.reset_n = reset_n;
    same("strobes", rtl->rd_n_o * 2 + rtl->wr_n_o, pins.rd_n * 2 + pins.wr_n, clock_);
    const bool was_selected = rtl->cs_n_o == 0;
    hi_ = hi_meta_;
    hi_meta_ = part_.out().hi;
    part_.step(in);
    bare_.step(bare);
    if (port_.takes_data()) given_ = bare_.out().d;
    port_.advance();
    rtl.tick();
    ++clock_;
    if (rtl->cs_n_o == 0 && !was_selected) begin();
    compare();
  }

  // Clocks in which nothing but the parts may move.
  void pass(std::int64_t n) {
    while (n > 0) {
      rtl.eval();
      const std::int64_t still = std::min<std::int64_t>(
          {n, std::int64_t{part_.next({})}, std::int64_t{bare_.next({})}});
      if (!rtl->quiescent_o || still < 2) {
        edge();
        --n;
        continue;
      }
      part_.advance(static_cast<exact::Gap>(still));
      bare_.advance(static_cast<exact::Gap>(still));
      clock_ += still;
      n -= still;
    }
  }

 private:
  virtual bool bus_idle() = 0;  // no transfer is asked for or waits

  static constexpr auto kData = sw::lm628_map::kData, kCommand = sw::lm628_map::kCommand;

  void begin() {
    auto& asked = rtl->drive_o ? writes_ : reads_;
    if (asked.empty()) throw std::logic_error("an access nobody asked for" + after_clock(clock_));
    port_.request(asked.front());
    asked.pop_front();
    ++accesses_;
  }

  void compare() {
    const exact::Lm628::Out a = part_.out(), b = bare_.out();
    same("d of the part", a.d, b.d, clock_);
    same("d_oe of the part", a.d_oe, b.d_oe, clock_);
    same("hi of the part", a.hi, b.hi, clock_);
    same("status of the part", part_.status(), bare_.status(), clock_);
    same("dac of the part", a.drive.dac, b.drive.dac, clock_);
  }

  exact::Lm628 part_, bare_;
  lm628::HostPort port_;
  std::deque<cosim::BusOp> writes_, reads_;  // expected
  std::uint8_t given_ = 0;
  bool hi_ = false, hi_meta_ = false;
  std::int64_t clock_ = 0;
  int accesses_ = 0;
};

}  // namespace trammel::test
