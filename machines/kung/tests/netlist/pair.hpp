// SPDX-License-Identifier: Apache-2.0
//
// Two models of a board with kung_soc, its RTL and its placed netlist, in step as one chip of the
// closed loop: both see the pins, the netlist drives the plant, and all outputs are compared after
// every clock. The processor is inside, so there is no bus; a console types on the serial port.
#pragma once

#include <verilated.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cosim/cosim.hpp"
#include "machines/kung/chip/pins.hpp"
#include "machines/kung/chip/verilated/adc.hpp"

namespace trammel::kung {

// An output that was not equal.
struct Difference {
  cosim::Clk clock = -1;
  std::string port;
  std::uint32_t rtl = 0, netlist = 0;
};

// Bytes on a serial line, 8 bits without parity, the lowest first.
class Typist {
 public:
  static constexpr cosim::Clk kBit = 434;  // [clk] 115,200 baud at 50 MHz

  Typist(std::string text, cosim::Clk from) : text_(std::move(text)), from_(from) {}

  bool level(cosim::Clk n) const {
    if (n < from_) return true;
    const auto at = static_cast<std::size_t>((n - from_) / kBit);
    if (at / 10 >= text_.size()) return true;
    const std::size_t bit = at % 10;
    if (bit == 0) return false;
    return bit == 9 || ((static_cast<unsigned char>(text_[at / 10]) >> (bit - 1)) & 1u) != 0;
  }
  bool changes(cosim::Clk n) const { return n >= from_ && (n - from_) % kBit == 0; }

 private:
  std::string text_;
  cosim::Clk from_;
};

// What comes out of it.
class Listener {
 public:
  void hear(cosim::Clk n, bool level) {
    if (at_ < 0 && !level) at_ = n + Typist::kBit * 3 / 2;
    if (at_ < 0 || n != at_) return;
    if (bits_ < 8) {
      byte_ |= static_cast<unsigned>(level) << bits_++;
      at_ += Typist::kBit;
    } else {
      text_ += static_cast<char>(byte_);
      at_ = -1;
      byte_ = 0;
      bits_ = 0;
    }
  }
  const std::string& text() const { return text_; }

 private:
  cosim::Clk at_ = -1;  // edge of the next bit
  unsigned byte_ = 0, bits_ = 0;
  std::string text_;
};

template <class Rtl, class Netlist>
class Pair final : public cosim::Chip {
 public:
  static constexpr std::size_t kMost = 20;  // differences that are kept

  Pair(std::string typed, cosim::Clk from) : typist_(std::move(typed), from) {
    both([](auto& m) {
      m.btn_reset_i = 0;
      m.driver_fault_n_i = 3;
      m.spare_i = 3;
      m.adc_sdata_a_i = m.adc_sdata_b_i = 0;
      m.ftdi_txd_i = 1;
      m.clk_25mhz_i = 0;
    });
    netlist_.flip_i = 0;
    sense(0);
  }

  cosim::Clk now() const override { return now_; }

  void sense(cosim::Lines lines) override {
    both([&](auto& m) { sense_encoders(m, lines); });
  }

  void request(const cosim::BusOp&) override { throw std::logic_error("the bus is inside"); }

  cosim::Stop run(cosim::Clk end, const cosim::Plant& plant) override {
    while (now_ < end) {
      const cosim::Clk edge = now_;
      if (typist_.changes(edge)) {
        both([&](auto& m) { m.ftdi_txd_i = typist_.level(edge); });
      }
      both([](auto& m) {
        m.clk_25mhz_i = 0;
        m.eval();
        m.clk_25mhz_i = 1;
        m.eval();
      });
      ++now_;
      compare(edge);
      listener_.hear(edge, netlist_.ftdi_rxd_o != 0);
      serve_converters(edge, plant);
      if (netlist_.gate_hi_o != hi_ || netlist_.gate_lo_o != lo_) {
        hi_ = netlist_.gate_hi_o;
        lo_ = netlist_.gate_lo_o;
        if (gate_changes_++ == 0) first_ = edge;
        return {edge, cosim::kDrive};
      }
    }
    return {now_ - 1, cosim::kLimit};
  }

  cosim::Lines drive() const override { return gates(hi_, lo_); }

  bool irq() const override { return false; }
  std::uint32_t rdata() const override { return 0; }

  // Flips one bit of a lookup table, see scripts/trammel_tools/synth/placed.py; 0 flips none.
  void flip(unsigned which) { netlist_.flip_i = static_cast<std::uint8_t>(which); }

  std::int64_t different() const { return different_; }
  cosim::Clk first_gate() const { return first_; }
  std::int64_t gate_changes() const { return gate_changes_; }
  const std::vector<Difference>& differences() const { return differences_; }
  const std::string& said() const { return listener_.text(); }

 private:
  template <class F>
  void both(F f) {
    f(rtl_);
    f(netlist_);
  }

  void compare(cosim::Clk edge) {
    same(edge, "gate_hi_o", rtl_.gate_hi_o, netlist_.gate_hi_o);
    same(edge, "gate_lo_o", rtl_.gate_lo_o, netlist_.gate_lo_o);
    same(edge, "driver_en_o", rtl_.driver_en_o, netlist_.driver_en_o);
    same(edge, "adc_cs_n_o", rtl_.adc_cs_n_o, netlist_.adc_cs_n_o);
    same(edge, "adc_sclk_o", rtl_.adc_sclk_o, netlist_.adc_sclk_o);
    same(edge, "ftdi_rxd_o", rtl_.ftdi_rxd_o, netlist_.ftdi_rxd_o);
    same(edge, "wifi_gpio0_o", rtl_.wifi_gpio0_o, netlist_.wifi_gpio0_o);
    same(edge, "led_o", rtl_.led_o, netlist_.led_o);
  }

  void same(cosim::Clk edge, const char* port, std::uint32_t rtl, std::uint32_t netlist) {
    if (rtl == netlist) return;
    if (++different_ <= static_cast<std::int64_t>(kMost)) {
      differences_.push_back({edge, port, rtl, netlist});
    }
  }

  void serve_converters(cosim::Clk edge, const cosim::Plant& plant) {
    const unsigned cs = netlist_.adc_cs_n_o, sclk = netlist_.adc_sclk_o;
    if (cs == cs_n_ && sclk == sclk_) return;
    for (int axis = 0; axis < kAxes; ++axis) {
      const unsigned bit = 1u << axis;
      auto& pair = adc_[static_cast<std::size_t>(axis)];
      if ((cs_n_ & ~cs & bit) != 0) {
        for (int phase = 0; phase < 2; ++phase) {
          pair[static_cast<std::size_t>(phase)].hold(
              plant.sample(adc_channel(axis, phase), edge));
        }
      } else if ((sclk_ & ~sclk & bit) != 0) {
        for (auto& adc : pair) adc.clock_fell();
      }
    }
    cs_n_ = cs;
    sclk_ = sclk;
    both([&](auto& m) {
      m.adc_sdata_a_i = static_cast<std::uint8_t>(adc_[0][0].data() | (adc_[1][0].data() << 1));
      m.adc_sdata_b_i = static_cast<std::uint8_t>(adc_[0][1].data() | (adc_[1][1].data() << 1));
    });
  }

  VerilatedContext rtl_context_, netlist_context_;
  Rtl rtl_{&rtl_context_, ""};
  Netlist netlist_{&netlist_context_, ""};
  Typist typist_;
  Listener listener_;
  cosim::Clk now_ = 0;
  std::array<std::array<SerialAdc, 2>, kAxes> adc_{};
  unsigned cs_n_ = 3, sclk_ = 3, hi_ = 0, lo_ = 0;
  std::int64_t different_ = 0, gate_changes_ = 0;
  cosim::Clk first_ = -1;
  std::vector<Difference> differences_;
};

}  // namespace trammel::kung
