// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/bus/serial2002_tx.sv.
#pragma once

#include <cstdint>

#include "models/exact/bus/frame_fifo.hpp"

namespace trammel::exact {

class Serial2002Tx {
 public:
  struct In {
    bool waits = false;
    Frame frame;
    bool busy = false;  // the line
  };
  struct Out {
    bool send = false, take = false;
    std::uint8_t byte = 0;
  };

  void reset() { *this = Serial2002Tx(); }

  // Leading bytes.
  static int leads(const Frame& frame) {
    if (frame.kind < Frame::kValue) return 0;
    int leads = 1;
    for (const int bits : {9, 16, 23, 30}) leads += frame.value >> bits != 0 ? 1 : 0;
    return leads;
  }
  // Its byte with so many leading ones behind it and itself, 0 = the last.
  static std::uint8_t byte(const Frame& f, int left) {
    if (left > 0) {
      return static_cast<std::uint8_t>(0x80 | (std::uint64_t{f.value} >> (7 * left - 5) & 0x7F));
    }
    const std::uint32_t high = (f.kind < Frame::kValue ? f.kind : f.value) & 3;
    return static_cast<std::uint8_t>(high << 5 | f.channel);
  }

  // In the present clock.
  Out out(const In& in) const {
    const bool send = sends_ && !in.busy;
    return {send, send && left_ == 0, byte(in.frame, left_)};
  }

  bool idle(const In& in) const { return !sends_ && !in.waits && !in.busy; }

  void step(const In& in) {
    if (!sends_) {
      sends_ = in.waits;
      if (in.waits) left_ = leads(in.frame);
    } else if (!in.busy) {
      sends_ = left_ != 0;
      if (left_ > 0) --left_;
    }
  }

  bool quiescent(const In& in) const { return sends_ ? in.busy : !in.waits; }

 private:
  bool sends_ = false;
  int left_ = 0;
};

}  // namespace trammel::exact
