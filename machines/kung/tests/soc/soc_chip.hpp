// SPDX-License-Identifier: Apache-2.0
//
// kung_soc as one verilated model behind the Chip interface: every clock is evaluated, nothing
// leaps, and what its processor transfers is recorded where both halves meet.
#pragma once

#include <Vkung_soc.h>
#include <Vkung_soc___024root.h>
#include <verilated.h>

#include <array>
#include <memory>
#include <vector>

#include "cosim/cosim.hpp"
#include "cosim/serial_host.hpp"
#include "machines/kung/chip/pins.hpp"
#include "machines/kung/chip/soc.hpp"
#include "machines/kung/chip/verilated/adc.hpp"
#include "machines/kung/tests/soc/transfer.hpp"

namespace trammel::test {

class SocChip final : public cosim::Chip {
 public:
  explicit SocChip(const kung::CoreMemory& memory) {
    context_->randReset(2);
    context_->randSeed(7);
    model_ = std::make_unique<Vkung_soc>(context_.get(), "");
    Vkung_soc& m = *model_;
    m.uart_rx_i = 1;
    m.driver_fault_i = 0;
    m.adc_sdata_a_i = m.adc_sdata_b_i = 0;
    sense(0);
    auto& words = m.rootp->kung_soc__DOT__u_host__DOT__u_ram__DOT__words;
    const std::size_t size = sizeof words / 4;
    for (std::size_t n = 0; n < size; ++n) words[n] = n < memory.size() ? memory[n] : 0;
    m.rst_i = 1;
    for (int n = 0; n < 4; ++n) tick();
    m.rst_i = 0;
    eval();
    remember();
  }
  ~SocChip() override { model_->final(); }
  SocChip(const SocChip&) = delete;
  SocChip& operator=(const SocChip&) = delete;

  cosim::Clk now() const override { return now_; }
  void request(const cosim::BusOp&) override {}  // its processor is inside
  bool irq() const override { return false; }
  std::uint32_t rdata() const override { return 0; }
  cosim::Lines drive() const override { return drive_; }

  void sense(cosim::Lines lines) override {
    kung::sense_encoders(*model_, lines);
    model_->driver_fault_i = level(lines, kung::kTripPin);
  }

  cosim::Stop run(cosim::Clk end, const cosim::Plant& plant) override {
    Vkung_soc& m = *model_;
    const auto& root = *m.rootp;
    while (now_ < end) {
      const cosim::Clk edge = now_;
      if (host != nullptr) {
        m.uart_rx_i = host->level(edge);
        host->see(edge, m.uart_tx_o != 0);
      }
      eval();
      if ((m.status_o >> 3 & 1u) != 0) trapped = std::min(trapped, edge);
      if (root.kung_soc__DOT__bus_valid && root.kung_soc__DOT__bus_ready) {
        const bool write = root.kung_soc__DOT__bus_wstrb != 0;
        transfers.push_back({edge, root.kung_soc__DOT__bus_addr,
                             write ? root.kung_soc__DOT__bus_wdata : root.kung_soc__DOT__bus_rdata,
                             write});
      }
      m.clk_i = 1;
      m.eval();
      ++now_;
      serve_converters(edge, plant);
      const cosim::Lines before = drive_;
      remember();
      if (drive_ != before) return {edge, cosim::kDrive};
    }
    return {now_ - 1, cosim::kLimit};
  }

  Vkung_soc& pins() { return *model_; }
  // Without a plant: the pins of the sensors stay as they are.
  void clock() {
    tick();
    ++now_;
  }

  std::vector<Transfer> transfers;
  cosim::Clk trapped = cosim::kNever;  // edge before which the core's trap is high
  cosim::SerialHost* host = nullptr;

 private:
  void eval() {
    model_->clk_i = 0;
    model_->eval();
  }
  void tick() {
    eval();
    model_->clk_i = 1;
    model_->eval();
  }

  void serve_converters(cosim::Clk edge, const cosim::Plant& plant) {
    Vkung_soc& m = *model_;
    for (int axis = 0; axis < kung::kAxes; ++axis) {
      const unsigned bit = 1u << axis;
      for (int phase = 0; phase < 2; ++phase) {
        auto& adc = adc_[static_cast<std::size_t>(2 * axis + phase)];
        if ((cs_n_ & ~m.adc_cs_n_o & bit) != 0) {
          adc.hold(plant.sample(kung::adc_channel(axis, phase), edge));
        } else if ((sclk_ & ~m.adc_sclk_o & bit) != 0) {
          adc.clock_fell();
        }
      }
    }
    cs_n_ = m.adc_cs_n_o;
    sclk_ = m.adc_sclk_o;
    m.adc_sdata_a_i = static_cast<std::uint8_t>(adc_[0].data() | adc_[2].data() << 1);
    m.adc_sdata_b_i = static_cast<std::uint8_t>(adc_[1].data() | adc_[3].data() << 1);
  }

  void remember() { drive_ = kung::gates(model_->gate_hi_o, model_->gate_lo_o); }

  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Vkung_soc> model_;
  cosim::Clk now_ = 0;
  cosim::Lines drive_ = 0;
  std::array<kung::SerialAdc, 4> adc_;  // X a, X b, Y a, Y b
  unsigned cs_n_ = 3, sclk_ = 0;
};

}  // namespace trammel::test
