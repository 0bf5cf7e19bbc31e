// SPDX-License-Identifier: Apache-2.0
//
// The verilated chip kung_xy on the bench: bus, encoders, converters and counters of its edges.
// No plant: the currents are the codes the test sets.
#pragma once

#include <Vkung_xy.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "rtl/chips/generated/kung_xy_regs.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

namespace trammel::test {

class KungBench {
 public:
  static constexpr int kPatience = 1000;  // edges that a bus transfer may take

  KungBench() {
    rtl_->leap_i = 0;
    rtl_->s_axil_awvalid_i = rtl_->s_axil_wvalid_i = rtl_->s_axil_arvalid_i = 0;
    rtl_->s_axil_awprot_i = rtl_->s_axil_arprot_i = 0;
    rtl_->s_axil_wstrb_i = 0xf;
    rtl_->s_axil_bready_i = rtl_->s_axil_rready_i = 1;
    rtl_->enc_a_i = rtl_->enc_b_i = rtl_->enc_z_i = 0;
    rtl_->trip_i = 0;
    rtl_->adc_sdata_a_i = rtl_->adc_sdata_b_i = 0;
    rtl_.reset();
    edges(200);  // encoder lines adopted, rule tables filled, first sample over
  }

  Vkung_xy* operator->() { return rtl_.operator->(); }

  // Codes that the converters hold at their next frame, 2048 = 0 A.
  struct Codes {
    unsigned a = 2048, b = 2048;
  };
  std::array<Codes, 2> codes{};

  // Clocks in which each gate was on, X a, b, c then Y.
  std::array<int, 6> on_hi{}, on_lo{};

  std::int64_t now() const { return now_; }

  // One clock edge, with the converters behind the pins.
  void edge() {
    const unsigned cs = rtl_->adc_cs_n_o;
    const unsigned sclk = rtl_->adc_sclk_o;
    rtl_.tick();
    ++now_;
    unsigned data_a = 0, data_b = 0;
    for (unsigned axis = 0; axis < 2; ++axis) {
      Frame& frame = frames_[axis];
      const unsigned bit = 1u << axis;
      if ((cs & bit) != 0 && (rtl_->adc_cs_n_o & bit) == 0) {
        frame = {codes[axis].a, codes[axis].b, 15};
      }
      if ((sclk & bit) != 0 && (rtl_->adc_sclk_o & bit) == 0 && frame.bit > 0) --frame.bit;
      data_a |= ((frame.a >> frame.bit) & 1u) << axis;
      data_b |= ((frame.b >> frame.bit) & 1u) << axis;
    }
    rtl_->adc_sdata_a_i = static_cast<std::uint8_t>(data_a);
    rtl_->adc_sdata_b_i = static_cast<std::uint8_t>(data_b);
    rtl_.eval();
    if ((rtl_->gate_hi_o & rtl_->gate_lo_o) != 0) {
      throw std::runtime_error("shoot-through" + after_clock(now_));
    }
    for (std::size_t gate = 0; gate < 6; ++gate) {
      on_hi[gate] += rtl_->gate_hi_o >> gate & 1;
      on_lo[gate] += rtl_->gate_lo_o >> gate & 1;
    }
  }

  void edges(int n) {
    for (int i = 0; i < n; ++i) edge();
  }

  // One edge that also stands for the edges after it that would only count; returns how many.
  int leap_edge() {
    const unsigned more = rtl_->quiescent_o != 0 && rtl_->next_o > 0 ? rtl_->next_o - 1u : 0u;
    rtl_->leap_i = static_cast<std::uint16_t>(more);
    edge();
    rtl_->leap_i = 0;
    rtl_.eval();
    now_ += more;
    return 1 + static_cast<int>(more);
  }

  // Edges until `condition` holds after one; throws when it never does.
  template <class Condition>
  int until(Condition condition, int limit = 300000) {
    for (int n = 1; n <= limit; ++n) {
      edge();
      if (condition()) return n;
    }
    throw std::runtime_error("the chip never came there" + after_clock(now_));
  }

  // Leaps; the condition is looked at after each evaluated edge only.
  template <class Condition>
  void leap_until(Condition condition, int patience = 300000) {
    int clocks = 0;
    do {
      clocks += leap_edge();
      if (clocks > patience) {
        throw std::runtime_error("the chip never came there" + after_clock(now_));
      }
    } while (!condition());
  }

  void leap_to_tick() {
    leap_until([this] { return rtl_->tick_o != 0; });
  }

  void leap_to_sample() {
    leap_until([this] { return rtl_->sample_o != 0; });
  }

  // The next edge acts on a 2 kHz tick.
  int to_tick() {
    return until([this] { return rtl_->tick_o != 0; });
  }

  int to_sample() {
    return until([this] { return rtl_->sample_o != 0; });
  }

  // An assertion of the RTL that fails in a transfer is told with its register.
  void write(std::uint32_t addr, std::uint32_t data) {
    INFO("write of " << register_name(kung_xy_regs::kRegisters, addr) << ": " << number(data, 8));
    rtl_->s_axil_awaddr_i = static_cast<std::uint16_t>(addr);
    rtl_->s_axil_wdata_i = data;
    rtl_->s_axil_awvalid_i = rtl_->s_axil_wvalid_i = 1;
    rtl_.eval();
    for (int waited = 0; rtl_->s_axil_bvalid_o == 0; ++waited) {
      if (waited > kPatience) fail("a write without response", addr);
      const bool aw = rtl_->s_axil_awready_o != 0, w = rtl_->s_axil_wready_o != 0;
      edge();
      if (aw) rtl_->s_axil_awvalid_i = 0;
      if (w) rtl_->s_axil_wvalid_i = 0;
      rtl_.eval();
    }
    if (rtl_->s_axil_bresp_o != 0) fail("a write is answered by an error", addr);
    edge();
  }

  std::uint32_t read(std::uint32_t addr) {
    INFO("read of " << register_name(kung_xy_regs::kRegisters, addr));
    rtl_->s_axil_araddr_i = static_cast<std::uint16_t>(addr);
    rtl_->s_axil_arvalid_i = 1;
    rtl_.eval();
    for (int waited = 0; rtl_->s_axil_rvalid_o == 0; ++waited) {
      if (waited > kPatience) fail("a read without response", addr);
      const bool ar = rtl_->s_axil_arready_o != 0;
      edge();
      if (ar) rtl_->s_axil_arvalid_i = 0;
      rtl_.eval();
    }
    if (rtl_->s_axil_rresp_o != 0) fail("a read is answered by an error", addr);
    const std::uint32_t data = rtl_->s_axil_rdata_o;
    edge();
    return data;
  }

  std::int32_t read_signed(std::uint32_t addr) { return static_cast<std::int32_t>(read(addr)); }

  unsigned fault_code() {
    namespace reg = kung_xy_regs;
    return (read(reg::kFault) & reg::kFaultCodeMask) >> reg::kFaultCodeShift;
  }

  bool gates_off() { return rtl_->gate_hi_o == 0 && rtl_->gate_lo_o == 0; }

  // Quadrature lines of one axis: phase 0..3 of 00 10 11 01 (A, B).
  void encoder(int axis, int phase) {
    const unsigned bit = 1u << axis;
    const auto put = [bit](unsigned lines, bool on) {
      return static_cast<std::uint8_t>(on ? lines | bit : lines & ~bit);
    };
    rtl_->enc_a_i = put(rtl_->enc_a_i, phase == 1 || phase == 2);
    rtl_->enc_b_i = put(rtl_->enc_b_i, phase == 2 || phase == 3);
    rtl_.eval();
  }

  void index(int axis, bool on) {
    const unsigned bit = 1u << axis;
    rtl_->enc_z_i = static_cast<std::uint8_t>(on ? rtl_->enc_z_i | bit : rtl_->enc_z_i & ~bit);
    rtl_.eval();
  }

 private:
  struct Frame {
    unsigned a = 0, b = 0;
    int bit = 15;
  };

  [[noreturn]] void fail(const char* what, std::uint32_t address) const {
    throw std::runtime_error(register_name(kung_xy_regs::kRegisters, address) + ": " + what +
                             after_clock(now_));
  }

  Rtl<Vkung_xy> rtl_;
  std::array<Frame, 2> frames_{};
  std::int64_t now_ = 0;
};

}  // namespace trammel::test
