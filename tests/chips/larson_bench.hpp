// SPDX-License-Identifier: Apache-2.0
//
// The chip larson_xy beside its twin, with every pin and word compared at every evaluated clock,
// leaping or not; and its words as a PDP-11 writes them.
#pragma once

#include <Vlarson_xy.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>

#include "models/exact/chips/larson_xy.hpp"
#include "tests/support/paced_master.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

namespace trammel::test {

class LarsonBench {
 public:
  exact::LarsonXy::In in;
  bool leaps = true;
  std::function<void()> watch;  // after each evaluated clock

  LarsonBench() {
    rtl_->leap_i = 0;
    bus_.reset(model());
    apply();
    for (int i = 0; i < 4; ++i) rtl_.tick();
    reset();
  }

  void reset() {
    bus_.reset(model());
    apply();
    rtl_.reset();
    for (int i = 0; i < 4; ++i) twin_.step(in);  // the synchronisers have none
    for (int i = 0; i < 4; ++i) rtl_.tick();
    rtl_.reset();
    twin_.reset();
  }

  std::int64_t now() const { return clock_; }  // [clk]
  exact::StepChannel::Out axis(std::size_t k) const { return twin_.table().axis(k); }
  bool irq() const { return twin_.irq(); }
  std::uint32_t err_byte() const { return twin_.table().err_byte(); }

  // A word of 16 bits at its offset: 0 X count, 2 X status, 4 Y count, 6 Y status.
  void mov(std::uint32_t offset, std::uint32_t word, const AxiPace& pace = {}) {
    AxiPace half = pace;
    half.strobes = (offset & 2) != 0 ? 12 : 3;
    transfer(offset & ~3u, word << ((offset & 2) != 0 ? 16 : 0), true, half);
  }
  void movb(std::uint32_t offset, std::uint32_t byte) {
    AxiPace one;
    one.strobes = 1u << (offset & 3);
    transfer(offset & ~3u, byte << 8 * (offset & 3), true, one);
  }
  std::uint32_t word(std::uint32_t offset) {
    return transfer(offset & ~3u, 0, false, {}) >> ((offset & 2) != 0 ? 16 : 0) & 0xFFFF;
  }
  // As the instruction BIS does it.
  void bis(std::uint32_t offset, std::uint32_t bits) { mov(offset, word(offset) | bits); }
  std::uint32_t vector() { return transfer(exact::LarsonXy::kVector, 0, false, {}); }
  std::uint32_t errors() { return transfer(exact::LarsonXy::kErrByte, 0, false, {}); }

  std::uint32_t transfer(std::uint32_t address, std::uint32_t data, bool write,
                         const AxiPace& pace) {
    bytes_ = pace.strobes;
    address_ = address;
    data_ = data;
    write_ = write;
    bus_.request(address, data, write, pace);
    while (bus_.active()) run(1);
    return bus_.rdata();
  }

  void clocks(std::int64_t n) {
    while (n > 0) n -= run(n);
  }
  // Until it holds, for so many clocks at most.
  template <class Condition>
  bool until(Condition condition, std::int64_t most) {
    while (!condition() && most > 0) most -= run(most);
    return condition();
  }

  // Up to n clocks, at least one.
  std::int64_t run(std::int64_t n) {
    apply();
    if (bus_.active() && bus_.before_edge(model())) twin_.request(address_, data_, write_, bytes_);
    rtl_.eval();
    std::int64_t gap = 1;
    if (rtl_->quiescent_o) {
      same("quiescent_o", 1, twin_.quiescent(in), clock_);
      same("next_o", rtl_->next_o, twin_.next(in), clock_);
      if (leaps) gap = std::clamp<std::int64_t>(rtl_->next_o, 1, n);
    }
    if (gap > 1) {
      twin_.advance(static_cast<exact::Gap>(gap));
    } else {
      twin_.step(in);
    }
    rtl_->leap_i = (gap - 1) & 0xFFF;
    rtl_.tick();
    rtl_->leap_i = 0;
    clock_ += gap;
    if (bus_.active()) bus_.after_edge(model());
    compare();
    if (watch) watch();
    return gap;
  }

 private:
  Vlarson_xy& model() { return *rtl_.operator->(); }

  void apply() {
    rtl_->limit_low_i = in.limit_low_i;
    rtl_->limit_high_i = in.limit_high_i;
    rtl_->buf_busy_i = in.buf_busy_i;
    rtl_.eval();
  }

  void compare() {
    const exact::LarsonXy::Out out = twin_.out();
    same("step_o", rtl_->step_o, out.step_o, clock_);
    same("forward_o", rtl_->forward_o, out.forward_o, clock_);
    same("flush_o", rtl_->flush_o, out.flush_o, clock_);
    same("irq_o", rtl_->irq_o, twin_.irq(), clock_);
    if (!bus_.active() && !write_) same("rdata", bus_.rdata(), twin_.read_data(), clock_);
  }

  Rtl<Vlarson_xy> rtl_;
  exact::LarsonXy twin_;
  PacedMaster bus_;
  std::uint32_t address_ = 0, data_ = 0, bytes_ = 15;
  bool write_ = true;
  std::int64_t clock_ = 0;
};

}  // namespace trammel::test
