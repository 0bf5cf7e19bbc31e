// SPDX-License-Identifier: Apache-2.0
//
// The processor's side of a UNIBUS with one device: DATI, DATO, DATOB and the interrupt cycle, with
// the order of lines of the PDP-11 Bus Handbook. `Device` has the pins of bus/word_unibus; `clock`
// passes one of its clocks.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace trammel::test {

template <class Device>
class Unibus {
 public:
  static constexpr int kSettle = 8;      // [clk] 150 ns of skew and decoding before MSYN
  static constexpr int kTimeout = 500;   // [clk] 10 us without SSYN are a bus error

  Unibus(Device& device, std::function<void()> clock) : device_(device), clock_(std::move(clock)) {
    device_->a_i = 0;
    device_->c_i = 0;
    device_->d_i = 0;
    device_->msyn_i = device_->bg_i = device_->bbsy_i = device_->ssyn_i = 0;
  }

  std::uint16_t dati(std::uint32_t address) {
    cycle(address, 0, 0);
    const auto data = static_cast<std::uint16_t>(device_->d_o);
    if (!device_->d_oe_o) throw std::logic_error("DATI: no data with SSYN");
    end();
    return data;
  }
  void dato(std::uint32_t address, std::uint16_t data) {
    cycle(address, 2, data);
    end();
  }
  void datob(std::uint32_t address, std::uint8_t data) {
    cycle(address, 3, static_cast<std::uint16_t>(data * 0x0101));
    end();
  }
  // No device answers.
  bool times_out(std::uint32_t address) {
    try {
      cycle(address, 0, 0);
    } catch (const std::runtime_error&) {
      end();
      return true;
    }
    end();
    return false;
  }

  bool requests() const { return device_->br_o; }

  // Grants, and takes the vector; -1: the device released the bus without one.
  int interrupt() {
    device_->bg_i = 1;
    wait([this] { return device_->sack_o || device_->bg_o; }, "SACK");
    if (device_->bg_o) {
      device_->bg_i = 0;
      for (int n = 0; n < kSettle; ++n) clock_();
      return -1;
    }
    device_->bg_i = 0;
    for (int n = 0; n < kTimeout && device_->sack_o; ++n) clock_();
    if (!device_->intr_o) return -1;
    for (int n = 0; n < kSettle; ++n) clock_();
    const int vector = device_->d_o;
    if (!device_->bbsy_o) throw std::logic_error("INTR without BBSY");
    device_->ssyn_i = 1;
    wait([this] { return !device_->intr_o; }, "the end of INTR");
    device_->ssyn_i = 0;
    for (int n = 0; n < kSettle; ++n) clock_();
    return vector;
  }

 private:
  void cycle(std::uint32_t address, unsigned control, std::uint16_t data) {
    device_->a_i = address & 0777777;
    device_->c_i = control & 3;
    device_->d_i = data;
    for (int n = 0; n < kSettle; ++n) clock_();
    device_->msyn_i = 1;
    wait([this] { return device_->ssyn_o; }, "SSYN");
    for (int n = 0; n < kSettle; ++n) clock_();  // of the data's skew
  }

  void end() {
    device_->msyn_i = 0;
    wait([this] { return !device_->ssyn_o; }, "the end of SSYN");
    for (int n = 0; n < kSettle; ++n) clock_();
  }

  template <class Condition>
  void wait(Condition condition, const std::string& what) {
    for (int n = 0; n < kTimeout; ++n) {
      if (condition()) return;
      clock_();
    }
    throw std::runtime_error("UNIBUS: no " + what);
  }

  Device& device_;
  std::function<void()> clock_;
};

}  // namespace trammel::test
