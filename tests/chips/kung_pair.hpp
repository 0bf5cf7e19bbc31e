// SPDX-License-Identifier: Apache-2.0
//
// kung_xy, or a board with it, beside its twin: gates and interrupt are compared at every evaluated
// clock, and every read. Converters and encoders are behind the pins.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "cosim/cosim.hpp"
#include "models/exact/chips/kung_xy.hpp"
#include "tests/support/paced_master.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

namespace trammel::test {

template <class Model>
class KungPair : public exact::KungXy::Converters {
 public:
  // Codes of phases a and b, X and Y; to be changed while no conversion runs.
  std::array<std::array<std::int32_t, 2>, 2> codes{{{2048, 2048}, {2048, 2048}}};
  // A, B, index of X, then of Y; above them the trip pin.
  std::uint64_t lines = 0;
  bool gated = false;  // each domain has its clock only where it is awake

  KungPair() {
    set_leap(model(), 0, 0);
    bus_.reset(model());
    apply();
  }

  Model* operator->() { return rtl_.operator->(); }
  Rtl<Model>& rtl() { return rtl_; }
  std::int64_t now() const { return twin_.now(); }     // since the reset
  std::int64_t gates_on() const { return gates_on_; }  // evaluated clocks with any gate on

  // After the edges of the RTL's reset: the twin begins anew.
  void begin() {
    twin_.reset();
    twin_.pins(lines);
    frames_ = {};
  }

  std::array<std::int32_t, 2> hold(int axis, exact::Clk) const override {
    return codes[static_cast<std::size_t>(axis)];
  }

  void clocks(std::int64_t n) {
    for (const std::int64_t end = now() + n; now() < end;) edge(end - now());
  }

  std::uint32_t read(std::uint32_t address, const AxiPace& pace = {}) {
    transfer({address, 0, false}, pace);
    if (bus_.rdata() != twin_.read_data()) {
      const std::string name = register_name(kung_xy_regs::kRegisters, address);
      same(name.c_str(), bus_.rdata(), twin_.read_data(), now());
    }
    return bus_.rdata();
  }
  void write(std::uint32_t address, std::uint32_t data) { transfer({address, data, true}); }

  void transfer(const cosim::BusOp& op, const AxiPace& pace = {}) {
    op_ = {op.addr, op.data, op.write, pace.bits()};
    bus_.request(op.addr, op.data, op.write, pace);
    while (bus_.active()) edge(1);
  }

  // A transfer that a reset ends after so many edges.
  void cut(const cosim::BusOp& op, const AxiPace& pace, int edges) {
    op_ = {op.addr, op.data, op.write, pace.bits()};
    bus_.request(op.addr, op.data, op.write, pace);
    for (int n = 0; n < edges && bus_.active(); ++n) edge(1);
    bus_.reset(model());
  }

  // Quadrature lines of an axis: one count up or down, with time for the filter.
  void count(int axis, int way) {
    auto& phase = phases_[static_cast<std::size_t>(axis)];
    phase = (phase + way) & 3;
    const std::uint64_t ab = (phase == 1 || phase == 2) | (phase >= 2) << 1;
    lines = (lines & ~(std::uint64_t{3} << 3 * axis)) | ab << 3 * axis;
    clocks(12);
  }

  // Lines at rest, as they are before a reset.
  void rest() {
    cosim::enable_all_clocks(model());
    lines = 0;
    phases_ = {};
    apply();
  }

 private:
  struct Frame {
    std::array<std::int32_t, 2> codes{};
    int bit = 15;
  };

  Model& model() { return *rtl_.operator->(); }

  // A board has no leap contract.
  template <class M>
  static auto set_leap(M& m, std::int64_t more, int) -> decltype(m.leap_i, void()) {
    m.leap_i = static_cast<std::uint16_t>(more);
  }
  template <class M>
  static void set_leap(M&, std::int64_t, long) {}
  template <class M>
  static auto leap_room(const M& m, int) -> decltype(m.next_o, std::int64_t{}) {
    return m.quiescent_o ? std::max<std::int64_t>(m.next_o, 1) : 1;
  }
  template <class M>
  static std::int64_t leap_room(const M&, long) {
    return 1;
  }

  void apply() {
    xy::sense_encoders(*rtl_.operator->(), lines);
    rtl_->trip_i = level(lines, xy::kTripPin);
    rtl_->adc_sdata_a_i = rtl_->adc_sdata_b_i = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Frame& frame = frames_[axis];
      rtl_->adc_sdata_a_i |= static_cast<std::uint8_t>((frame.codes[0] >> frame.bit & 1) << axis);
      rtl_->adc_sdata_b_i |= static_cast<std::uint8_t>((frame.codes[1] >> frame.bit & 1) << axis);
    }
    rtl_.eval();
  }

  void edge(std::int64_t limit) {
    apply();
    twin_.pins(lines);
    const bool transfer = bus_.active();
    if (transfer && bus_.before_edge(model())) twin_.request(op_);
    const std::int64_t gap = transfer ? 1 : std::min(limit, leap_room(model(), 0));
    const unsigned cs = rtl_->adc_cs_n_o, sclk = rtl_->adc_sclk_o;
    set_leap(model(), gap - 1, 0);
    if constexpr (cosim::kHasDomains<Model>) {
      if (gated) cosim::enable_clocks(rtl_->clock_en_i, static_cast<unsigned>(rtl_->awake_o));
    }
    rtl_.tick();
    set_leap(model(), 0, 0);
    if (transfer) bus_.after_edge(model());
    rtl_.eval();
    const std::int64_t end = twin_.now() + gap;
    twin_.run(end, *this);
    same("last edge of a leap", end - 1, twin_.now() - 1, end);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      Frame& frame = frames_[axis];
      const auto fell = [axis](unsigned before, unsigned after) {
        return (before >> axis & 1) != 0 && (after >> axis & 1) == 0;
      };
      if (fell(cs, rtl_->adc_cs_n_o)) frame = {codes[axis], 15};
      if (fell(sclk, rtl_->adc_sclk_o) && frame.bit > 0) --frame.bit;
    }
    const std::uint64_t gates = twin_.gates();
    same("gate_hi_o", rtl_->gate_hi_o, (gates & 7) | (gates >> 6 & 7) << 3, now());
    same("gate_lo_o", rtl_->gate_lo_o, (gates >> 3 & 7) | (gates >> 9 & 7) << 3, now());
    same("irq_o", rtl_->irq_o, twin_.irq(), now());
    gates_on_ += gates != 0;
  }

  Rtl<Model> rtl_;
  PacedMaster bus_;
  exact::KungXy twin_;
  exact::KungXy::BusOp op_;
  std::array<Frame, 2> frames_{};
  std::array<int, 2> phases_{};
  std::int64_t gates_on_ = 0;
};

}  // namespace trammel::test
