// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact twin of rtl/bus/serial2002_rx.sv.
#pragma once

#include <algorithm>
#include <cstdint>

#include "models/exact/bus/frame_fifo.hpp"
#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class Serial2002Rx {
 public:
  struct In {
    bool valid = false, bad = false;
    std::uint8_t byte = 0;
    std::uint32_t gap = 0;  // [clk] 24 bits
  };
  struct Out {
    bool valid = false, malformed = false;
    Frame frame;
  };

  void reset() { *this = Serial2002Rx(); }
  const Out& out() const { return out_; }

  Out step(const In& in) {
    out_.valid = out_.malformed = false;
    const bool silent = gap_.count() == 1 && !in.valid;
    gap_.step({in.valid, in.byte >= 0x80 ? in.gap : 0});
    if (silent) {
      out_.malformed = true;
      clear();
    }
    if (!in.valid) return out_;
    wrong_ = wrong_ || in.bad;
    if (in.byte >= 0x80) {
      // 32 bits, of which the last byte has two.
      if (leads_ == kLeads || (leads_ == kLeads - 1 && (value_ >> 23 & 31) != 0)) wrong_ = true;
      value_ = (value_ << 7 | (in.byte & 0x7Fu)) & 0x3FFFFFFF;
      leads_ = std::min(leads_ + 1, kLeads);
      return out_;
    }
    const std::uint32_t high = in.byte >> 5, channel = in.byte & 0x1Fu;
    out_.frame = leads_ > 0 ? Frame{Frame::kValue, channel, value_ << 2 | high}
                            : Frame{high, channel, 0};
    (wrong_ ? out_.malformed : out_.valid) = true;
    clear();
    return out_;
  }

  bool quiescent(const In& in) const {
    return !in.valid && !out_.valid && !out_.malformed && gap_.count() != 1;
  }
  Gap next() const { return gap_.next({}); }
  void advance(Gap n) { gap_.advance(n); }

 private:
  static constexpr int kLeads = 5;

  void clear() {
    wrong_ = false;
    value_ = 0;
    leads_ = 0;
  }

  Timer gap_;
  int leads_ = 0;
  std::uint32_t value_ = 0;
  bool wrong_ = false;
  Out out_;
};

}  // namespace trammel::exact
