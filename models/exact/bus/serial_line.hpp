// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/bus/serial_line.sv.
#pragma once

#include <algorithm>
#include <cstdint>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class SerialLine {
 public:
  struct In {
    bool send = false;
    std::uint8_t byte = 0;
    bool rx = true;
  };
  struct Out {
    bool busy = false, valid = false, bad = false;
    std::uint8_t byte = 0;
    bool tx = true;
  };

  explicit SerialLine(std::uint32_t clocks_per_bit = 434) : bit_(clocks_per_bit) {}

  void reset() { *this = SerialLine(bit_); }

  Out out() const { return {tx_left_ > 0, valid_, bad_, rx_bits_, (tx_bits_ & 1) != 0}; }

  void step(const In& in) {
    transmit(in);
    receive();
    rx_ = meta_;
    meta_ = in.rx;
  }

  bool quiescent(const In& in) const {
    const bool sends = tx_left_ == 0 ? in.send : tx_.count() == 1;
    const bool hears = rx_left_ == 0 ? !rx_ && !broken_ : rx_timer_.count() == 1;
    return !sends && !hears && !valid_ && !(broken_ && rx_) && in.rx == meta_ && meta_ == rx_;
  }
  Gap next() const { return std::min(tx_.next({}), rx_timer_.next({})); }
  void advance(Gap n) {
    tx_.advance(n);
    rx_timer_.advance(n);
  }

 private:
  static constexpr int kBits = 10;

  void transmit(const In& in) {
    if (tx_left_ == 0) {
      if (in.send) {
        tx_bits_ = 1u << 9 | std::uint32_t{in.byte} << 1;
        tx_left_ = kBits;
      }
      tx_.step({in.send, bit_});
    } else if (tx_.count() == 1) {
      tx_bits_ = tx_bits_ >> 1 | 1u << 9;
      --tx_left_;
      tx_.step({tx_left_ > 0, bit_});
    } else {
      tx_.step({});
    }
  }

  void receive() {
    valid_ = false;
    if (rx_left_ == 0) {
      const bool begins = !rx_ && !broken_;
      if (begins) rx_left_ = kBits;
      rx_timer_.step({begins, bit_ / 2});
      if (rx_) broken_ = false;
      return;
    }
    if (rx_timer_.count() != 1) {
      rx_timer_.step({});
      return;
    }
    if (rx_left_ == 1) {
      valid_ = true;
      bad_ = broken_ = !rx_;
    } else {
      rx_bits_ = static_cast<std::uint8_t>(rx_bits_ >> 1 | (rx_ ? 0x80 : 0));
    }
    rx_left_ = rx_left_ == kBits && rx_ ? 0 : rx_left_ - 1;
    rx_timer_.step({rx_left_ > 0, bit_});
  }

  std::uint32_t bit_;
  Timer tx_, rx_timer_;
  std::uint32_t tx_bits_ = 0x3FF;
  int tx_left_ = 0, rx_left_ = 0;
  bool meta_ = true, rx_ = true, valid_ = false, bad_ = false, broken_ = false;
  std::uint8_t rx_bits_ = 0;
};

}  // namespace trammel::exact
