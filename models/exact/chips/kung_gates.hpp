// SPDX-License-Identifier: Apache-2.0
//
// PWM and gates of one axis of kung_xy (rtl/drive/pwm.sv, gate_leg.sv and their wiring), edge by
// edge: next() is the first edge at which a leg does anything as long as enable, trip and the dead
// time hold; step() is due only there, and where one of these changes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "models/exact/chips/kung_time.hpp"
#include "models/exact/drive/carrier.hpp"

namespace trammel::exact {

class KungGates {
 public:
  struct In {
    bool enable = false;
    bool trip = false;
    std::uint32_t dead_time = 100;  // [clk]
  };

  // The register CTRL.enable changes at `edge`; legs see it one edge later.
  void enable_rises(Clk edge) { enabled_from_ = edge + 1; }

  // Edge n for all legs that are due, or for all.
  void step(Clk n, const In& in, bool all) {
    const bool allowed = in.enable && !in.trip;
    for (std::size_t k = 0; k < 3; ++k) {
      if (all || legs_[k].next == n) step(k, n, in, allowed);
    }
    next_ = std::min({legs_[0].next, legs_[1].next, legs_[2].next});
  }

  // The tick at edge n loads compare values and begins a period, after its step().
  void load(Clk n, const std::array<std::int32_t, 3>& cmp, std::uint32_t carrier) {
    begin_ = n;
    period_ = pwm_period(carrier);
    top_ = static_cast<std::int32_t>(cmp_max(carrier));
    for (std::size_t k = 0; k < 3; ++k) {
      legs_[k].cmp = cmp[k];
      // A switch still on (compare value 0) goes off at this edge, and the leg follows.
      if (legs_[k].allowed) legs_[k].next = std::min(ready(legs_[k]), change(legs_[k], n));
    }
    next_ = std::min({legs_[0].next, legs_[1].next, legs_[2].next});
  }

  Clk next() const { return next_; }

  // Bits 0..2: upper gates of a, b, c; bits 3..5: lower ones.
  unsigned gates() const { return gates_; }

 private:
  struct Leg {
    std::int32_t cmp = 0;  // loaded at the first edge
    bool allowed = false;  // at the previous edge
    bool side = false;
    Clk ready = 0;         // end of the dead time
    bool on = false;       // one of the gates
    Clk next = kNever;
  };

  // What the PWM shows after edge n: carrier above the compare value, phase 0 never.
  bool above(const Leg& leg, Clk n) const {
    const Clk phase = n - begin_;
    return n >= enabled_from_ && phase > leg.cmp && phase < period_ - leg.cmp;
  }

  static Clk ready(const Leg& leg) { return leg.on ? kNever : leg.ready; }

  // The first edge after n at which the leg sees the other side.
  Clk change(const Leg& leg, Clk n) const {
    const Clk up = begin_ + leg.cmp + 2, down = begin_ + period_ + 1 - leg.cmp;
    if (leg.side) return above(leg, n) ? down : n + 1;
    if (n < up) return leg.cmp < top_ ? up : kNever;
    return n + 1 < down ? n + 1 : kNever;
  }

  void step(std::size_t k, Clk n, const In& in, bool allowed) {
    Leg& leg = legs_[k];
    const bool up = above(leg, n - 1);
    bool on = false;
    if (allowed && (!leg.allowed || up != leg.side)) {
      leg.side = up;
      leg.ready = n + std::max<Clk>(1, in.dead_time);
    } else {
      on = allowed && n >= leg.ready;
    }
    leg.allowed = allowed;
    leg.on = on;
    leg.next = allowed ? std::min(ready(leg), change(leg, n)) : kNever;
    const unsigned bits = 9u << k;
    gates_ &= ~bits;
    if (on) gates_ |= bits & (leg.side ? 7u : 56u);
  }

  std::array<Leg, 3> legs_;
  Clk begin_ = -kLongAgo;       // of the PWM period
  Clk period_ = 0;              // [clk]
  std::int32_t top_ = 0;        // of the carrier
  Clk enabled_from_ = kNever;   // first edge at which the PWM sees its enable
  Clk next_ = kNever;
  unsigned gates_ = 0;
};

}  // namespace trammel::exact
