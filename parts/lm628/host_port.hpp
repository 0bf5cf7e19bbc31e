// SPDX-License-Identifier: Apache-2.0
//
// A bus master at the host port of the LM628, clock by clock in a fabric of 20 ns, by the data
// sheet's times (SNVS781C p.4): PS 30 ns before and after, RD 180 ns to the data and 180 ns more
// until they are off the bus, WR 100 ns, data held 120 ns after it, 120 ns between accesses.
#pragma once

#include <cstdint>

#include "cosim/cosim.hpp"
#include "sw_nios/hal/lm628.hpp"

namespace trammel::lm628 {

struct HostPins {
  bool cs_n = true, rd_n = true, wr_n = true, ps = false, reset_n = true;
  std::uint8_t d = 0;
};

class HostPort {
 public:
  static constexpr int kSetup = 2;      // [clk] CS, PS and data before a strobe
  static constexpr int kWrite = 5;      // WR low
  static constexpr int kWriteHold = 6;  // data, CS and PS after it
  static constexpr int kRead = 9;       // RD low; data are taken at its end
  static constexpr int kReadOff = 9;    // until the bus is free
  static constexpr int kReset = 80;     // RST low: 8 ticks of 6 MHz are 67

  bool active() const { return active_; }

  void request(const cosim::BusOp& op) {
    op_ = op;
    phase_ = 0;
    active_ = true;
  }

  // Pins for the next edge.
  HostPins pins() const {
    HostPins pins;
    if (!active_) return pins;
    if (op_.addr == sw::lm628_map::kReset) {
      pins.reset_n = !(op_.write && phase_ < kReset);
    } else if (to_part()) {
      const int strobe = phase_ - kSetup;
      pins.ps = op_.addr == sw::lm628_map::kData;
      pins.cs_n = !op_.write && strobe >= kRead;
      pins.wr_n = !(op_.write && strobe >= 0 && strobe < kWrite);
      pins.rd_n = !(!op_.write && strobe >= 0 && strobe < kRead);
      pins.d = static_cast<std::uint8_t>(op_.data);
    }
    return pins;
  }

  // After an edge: is this the one that takes the data of a read?
  bool takes_data() const {
    return active_ && to_part() && !op_.write && phase_ == kSetup + kRead - 1;
  }

  // Passes the edge; true at the last one of the transfer.
  bool advance() {
    if (!active_) return false;
    active_ = ++phase_ < length();
    return !active_;
  }

  const cosim::BusOp& op() const { return op_; }

 private:
  bool to_part() const {
    return op_.addr == sw::lm628_map::kCommand || op_.addr == sw::lm628_map::kData;
  }
  int length() const {
    if (to_part()) return op_.write ? kSetup + kWrite + kWriteHold : kSetup + kRead + kReadOff;
    return op_.addr == sw::lm628_map::kReset && op_.write ? kReset + 1 : 1;
  }

  cosim::BusOp op_;
  int phase_ = 0;
  bool active_ = false;
};

}  // namespace trammel::lm628
