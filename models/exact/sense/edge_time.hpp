// SPDX-License-Identifier: Apache-2.0
//
// Bit-exact, clock-exact twin of rtl/sense/edge_time.sv.
#pragma once

#include <cstdint>

namespace trammel::exact {

class EdgeTime {
 public:
  static constexpr int kPeriod = 3125;  // [clk] of a tick
  static constexpr int kMostTicks = 15;

  struct In {
    bool tick = false;
    bool edge = false;        // the count changes at this clock edge,
    bool up = false;          // this way
    std::int32_t phase = 0;   // [clk] since the tick
    int filter = 3;           // [clk] of the decoder; 0 acts as 1
  };

  struct Out {
    int ticks = kMostTicks;  // since the last edge before the tick, 15 = 15 or more
    std::int32_t age = 0;    // [clk] from that edge at the pin to the tick
    bool up = false;
  };

  void reset() { *this = EdgeTime(); }

  // One clock edge.
  void clock(const In& in) {
    if (in.tick) {
      if (seen_) {
        out_.ticks = 0;
        out_.age = kPeriod - phase_ + 2 + (in.filter == 0 ? 1 : in.filter);
        out_.up = up_;
      } else if (out_.ticks < kMostTicks) {
        ++out_.ticks;
        out_.age += kPeriod;
      }
      seen_ = false;
    }
    if (in.edge) {
      seen_ = true;
      phase_ = in.phase;
      up_ = in.up;
    }
  }

  const Out& out() const { return out_; }
  bool quiescent(const In& in) const {
    return !in.edge && !(in.tick && (seen_ || out_.ticks < kMostTicks));
  }

 private:
  bool seen_ = false;  // an edge since the tick,
  std::int32_t phase_ = 0;
  bool up_ = false;
  Out out_;
};

}  // namespace trammel::exact
