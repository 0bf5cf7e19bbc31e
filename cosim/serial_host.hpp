// SPDX-License-Identifier: Apache-2.0
//
// The other end of a serial line of 8 data bits, no parity, 1 stop bit: sends bytes and collects
// those that come, clock by clock. A clock in which the line to the chip changes is next().
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

class SerialHost {
 public:
  // `source` gives the next byte to send at an edge, or none yet: it is asked again 1 ms later, or
  // at ask_at(). With kNoStop its stop bit is low. `sink` takes a byte that came.
  using Source = std::function<std::optional<unsigned>(Clk)>;
  static constexpr unsigned kNoStop = 1u << 8;
  using Sink = std::function<void(unsigned char)>;

  SerialHost(Clk clocks_per_bit, Source source, Sink sink)
      : bit_(clocks_per_bit), source_(std::move(source)), sink_(std::move(sink)) {}

  // The line to the chip before edge n; edges rise.
  bool level(Clk n) {
    while (n >= next_) turn();
    return level_;
  }
  Clk next() const { return next_; }

  // The source has a byte at edge n, which is not yet passed.
  void ask_at(Clk n) {
    if (waits_) next_ = std::min(next_, n);
  }

  // The line from the chip before edge n.
  void see(Clk n, bool level) {
    if (left_ == 0) {
      if (!level) {
        left_ = kBits;
        sample_ = n + bit_ / 2;
      }
    } else if (n >= sample_) {
      shift_ = shift_ >> 1 | (level ? 1u << (kBits - 1) : 0);
      sample_ += bit_;
      --left_;
      // Start bit lowest, stop bit highest.
      if (left_ == 0 && level) sink_(static_cast<unsigned char>(shift_ >> 1 & 0xFFu));
    }
  }

 private:
  static constexpr int kBits = 10;

  void turn() {
    if (sending_ == 0) {
      const auto byte = source_(next_);
      waits_ = !byte;
      if (!byte) {
        level_ = true;
        next_ += kPatience;
        return;
      }
      frame_ = (*byte ^ kNoStop) << 1;
      sending_ = kBits;
    }
    level_ = (frame_ & 1u) != 0;
    frame_ >>= 1;
    --sending_;
    next_ += bit_;
  }

  static constexpr Clk kPatience = 50'000;  // 1 ms

  Clk bit_;
  Source source_;
  Sink sink_;
  bool level_ = true, waits_ = false;
  unsigned frame_ = 0;
  int sending_ = 0;
  Clk next_ = 0;
  unsigned shift_ = 0;
  int left_ = 0;
  Clk sample_ = 0;
};

}  // namespace trammel::cosim
