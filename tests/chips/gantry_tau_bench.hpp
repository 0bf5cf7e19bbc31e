// SPDX-License-Identifier: Apache-2.0
//
// The chip gantry_tau beside its twin, with every pin and word compared at every evaluated clock,
// leaping or not, with a converter, a non-volatile memory and the other end of the serial line.
#pragma once

#include <Vgantry_tau.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "cosim/serial_host.hpp"
#include "models/exact/chips/gantry_tau.hpp"
#include "models/plant/mcp3008.hpp"
#include "tests/support/paced_master.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

namespace trammel::test {

class GantryBench {
 public:
  exact::GantryTau::In in;
  bool leaps = true;
  bool nv_ready = true;
  std::array<std::uint16_t, 64> store{};
  std::deque<std::uint8_t> to_chip;     // bytes that the host sends
  std::vector<std::uint8_t> from_chip;  // bytes that came
  std::function<int(int channel, std::int64_t clock)> code = [](int, std::int64_t) { return 512; };
  std::function<void()> watch;  // after each evaluated clock

  explicit GantryBench(const exact::Calibration* calib = nullptr) {
    if (calib != nullptr) std::copy(calib->words.begin(), calib->words.end(), store.begin());
    rtl_->leap_i = 0;
    bus_.reset(model());
    apply();
    reset();
    if (calib != nullptr) clocks(200);
  }

  void reset() {
    bus_.reset(model());
    write_ = true;  // nothing was read since
    for (int i = 0; i < 4; ++i) {
      rtl_->rst_i = 1;
      apply();
      rtl_.tick();
      twin_.step(in);
    }
    rtl_.reset();
    twin_.reset();
    apply();
  }

  std::int64_t now() const { return clock_; }  // [clk]
  const exact::GantryTau& twin() const { return twin_; }
  std::int64_t evaluated() const { return evaluated_; }

  std::uint32_t transfer(std::uint32_t address, std::uint32_t data, bool write,
                         const AxiPace& pace = {}) {
    address_ = address;
    data_ = data;
    write_ = write;
    bits_ = pace.bits();
    bus_.request(address, data, write, pace);
    while (bus_.active()) run(1);
    return bus_.rdata();
  }
  void put(std::uint32_t address, std::uint32_t data) { transfer(address, data, true); }
  std::uint32_t get(std::uint32_t address) { return transfer(address, 0, false); }

  void clocks(std::int64_t n) {
    while (n > 0) n -= run(n);
  }
  template <class Condition>
  bool until(Condition condition, std::int64_t most) {
    while (!condition() && most > 0) most -= run(most);
    return condition();
  }

  // Up to n clocks, at least one.
  std::int64_t run(std::int64_t n) {
    in.rx_i = host_.level(clock_);
    apply();
    if (bus_.active() && bus_.before_edge(model())) twin_.request(address_, data_, write_, bits_);
    rtl_.eval();
    std::int64_t gap = 1;
    if (rtl_->quiescent_o) {
      same("quiescent_o", 1, twin_.quiescent(in), clock_);
      same("next_o", rtl_->next_o, twin_.next(in), clock_);
      if (leaps) gap = std::clamp<std::int64_t>(rtl_->next_o, 1, n);
      gap = std::min(gap, std::max<std::int64_t>(1, host_.next() - clock_));
    }
    if (gap > 1) {
      twin_.advance(static_cast<exact::Gap>(gap));
    } else {
      twin_.step(in);
    }
    ++evaluated_;
    rtl_->leap_i = (gap - 1) & 0xFFF;
    rtl_.tick();
    rtl_->leap_i = 0;
    clock_ += gap;
    if (bus_.active()) bus_.after_edge(model());
    compare();
    serve();
    if (watch) watch();
    return gap;
  }

 private:
  Vgantry_tau& model() { return *rtl_.operator->(); }

  void apply() {
    in.nv_ready_i = nv_ready;
    in.nv_data_i = store[twin_.out().nv_addr_o];
    rtl_->adc_dout_i = in.adc_dout_i;
    rtl_->nv_ready_i = in.nv_ready_i;
    rtl_->nv_data_i = in.nv_data_i;
    rtl_->overtemp_i = in.overtemp_i;
    rtl_->rx_i = in.rx_i;
    rtl_.eval();
  }

  void serve() {
    const exact::GantryTau::Out out = twin_.out();
    in.adc_dout_i = adc_.step(out.adc_cs_n_o, out.adc_sclk_o, out.adc_din_o,
                              [&](int channel) { return code(channel, clock_ - 1); });
    if (out.nv_valid_o && out.nv_write_o && nv_ready) store[out.nv_addr_o] = out.nv_data_o;
    host_.see(clock_, out.tx_o);
  }

  void compare() {
    const exact::GantryTau::Out out = twin_.out();
    same("pwm_o", rtl_->pwm_o, out.pwm_o, clock_);
    same("negative_o", rtl_->negative_o, out.negative_o, clock_);
    same("adc_cs_n_o", rtl_->adc_cs_n_o, out.adc_cs_n_o, clock_);
    same("adc_sclk_o", rtl_->adc_sclk_o, out.adc_sclk_o, clock_);
    same("adc_din_o", rtl_->adc_din_o, out.adc_din_o, clock_);
    same("nv_valid_o", rtl_->nv_valid_o, out.nv_valid_o, clock_);
    same("nv_write_o", rtl_->nv_write_o, out.nv_write_o, clock_);
    same("nv_addr_o", rtl_->nv_addr_o, out.nv_addr_o, clock_);
    same("nv_data_o", rtl_->nv_data_o, out.nv_data_o, clock_);
    same("tx_o", rtl_->tx_o, out.tx_o, clock_);
    same("irq_o", rtl_->irq_o, twin_.irq(), clock_);
    same("pass_o", rtl_->pass_o, twin_.pass(), clock_);
    if (!bus_.active() && !write_) {
      same(register_name(gantry_tau_regs::kRegisters, address_).c_str(), bus_.rdata(),
           twin_.read_data(), clock_);
    }
  }

  Rtl<Vgantry_tau> rtl_;
  exact::GantryTau twin_;
  PacedMaster bus_;
  plant::Mcp3008 adc_;
  cosim::SerialHost host_{434,
                          [this](cosim::Clk) -> std::optional<unsigned char> {
                            if (to_chip.empty()) return std::nullopt;
                            const unsigned char byte = to_chip.front();
                            to_chip.pop_front();
                            return byte;
                          },
                          [this](unsigned char byte) { from_chip.push_back(byte); }};
  std::uint32_t address_ = 0, data_ = 0, bits_ = ~0u;
  bool write_ = true;
  std::int64_t clock_ = 0, evaluated_ = 0;
};

}  // namespace trammel::test
