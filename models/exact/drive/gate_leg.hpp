// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/drive/gate_leg.sv.
#pragma once

#include <cstdint>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class GateLeg {
 public:
  struct In {
    bool enable = false;
    bool trip = false;
    bool on = false;
    std::uint32_t dead_time = 100;  // [clk] 0..1023, 0 acts as 1
  };

  struct Out {
    bool hi = false;
    bool lo = false;

    bool operator==(const Out& o) const { return hi == o.hi && lo == o.lo; }
  };

  void reset() { *this = GateLeg(); }

  Out step(const In& in) {
    const Out gates = after(in);
    timer_.step({starts(in), in.dead_time});
    if (allowed(in)) side_ = in.on;
    allowed_ = allowed(in);
    return out_ = gates;
  }

  const Out& out() const { return out_; }

  bool quiescent(const In& in) const {
    return allowed(in) == allowed_ && !starts(in) && after(in) == out_;
  }

  Gap next(const In& in) const { return timer_.next({starts(in), in.dead_time}); }

  void advance(Gap n) { timer_.advance(n); }

 private:
  static bool allowed(const In& in) { return in.enable && !in.trip; }

  // A dead time starts: the gates are allowed again, or the side changes.
  bool starts(const In& in) const { return allowed(in) && (!allowed_ || in.on != side_); }

  Out after(const In& in) const {
    const bool ready = allowed(in) && !starts(in) && timer_.count() <= 1;
    return {ready && in.on, ready && !in.on};
  }

  Timer timer_;
  bool allowed_ = false;  // at the previous edge
  bool side_ = false;
  Out out_;
};

}  // namespace trammel::exact
