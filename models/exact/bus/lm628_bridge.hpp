// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/bus/lm628_bridge.sv.
#pragma once

#include <cstdint>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

class Lm628Bridge {
 public:
  static constexpr std::uint32_t kSetup = 2;    // [clk] before a pulse
  static constexpr std::uint32_t kPulse = 275;  // [clk] 5.5 us at 50 MHz
  static constexpr std::uint32_t kHold = 9;     // [clk] after it

  struct In {
    bool write_strobe = false, read_strobe = false;  // port B
    bool ps = false, read = false, y = false;
    std::uint8_t to_part = 0;                        // port C
    std::uint8_t d_x = 0, d_y = 0;                   // of the parts
  };

  struct Out {
    bool cs_x_n = false, cs_y_n = true, rd_n = true, wr_n = true, ps = false;
    std::uint8_t d = 0;
    bool transceiver = true, selector = false;
  };

  void reset() { *this = Lm628Bridge(); }

  Out out() const {
    const bool pulse = state_ == State::kPulse;
    Out out;
    out.cs_x_n = pins_.y || change_;
    out.cs_y_n = !pins_.y || change_;
    out.rd_n = !(pulse && pins_.read);
    out.wr_n = !(pulse && !pins_.read);
    out.ps = pins_.ps;
    out.d = pins_.d;
    out.transceiver = !pins_.read && !change_;
    out.selector = pins_.read && !change_;
    return out;
  }
  std::uint8_t from_part() const { return byte_; }
  bool busy(const In& in) const { return state_ != State::kRest || starts(in); }

  // A strobe that rises at this edge starts nothing.
  bool refuses(const In& in) const {
    return (write_rises(in) && !(starts(in) && !in.read)) ||
           (read_rises(in) && !(starts(in) && in.read));
  }

  bool quiescent(const In& in) const {
    return !change_ && in.write_strobe == write_was_ && in.read_strobe == read_was_ &&
           (state_ == State::kRest ? ports(in) == pins_ : timer_.count() != 0);
  }
  Gap next() const { return timer_.next({}); }
  void advance(Gap n) { timer_.advance(n); }

  void step(const In& in) {
    const bool begins = starts(in), last = timer_.count() == 0;
    const bool change = state_ == State::kRest && (in.read != pins_.read || in.y != pins_.y);
    timer_.step({});
    switch (state_) {
      case State::kRest:
        pins_ = ports(in);
        if (begins) enter(State::kSetup, kSetup);
        break;
      case State::kSetup:
        // The clock in which nothing was selected does not count as set-up time.
        if (change_) {
          enter(State::kSetup, kSetup);
        } else if (last) {
          enter(State::kPulse, kPulse);
        }
        break;
      case State::kPulse:
        if (!last) break;
        if (pins_.read) byte_ = pins_.y ? in.d_y : in.d_x;
        enter(State::kHold, kHold);
        break;
      case State::kHold:
        if (last) state_ = State::kRest;
    }
    change_ = change;
    write_was_ = in.write_strobe;
    read_was_ = in.read_strobe;
  }

 private:
  enum class State { kRest, kSetup, kPulse, kHold };

  struct Pins {
    bool ps = false, read = false, y = false;
    std::uint8_t d = 0;
    bool operator==(const Pins& o) const {
      return ps == o.ps && read == o.read && y == o.y && d == o.d;
    }
  };

  static Pins ports(const In& in) { return {in.ps, in.read, in.y, in.to_part}; }
  bool write_rises(const In& in) const { return in.write_strobe && !write_was_; }
  bool read_rises(const In& in) const { return in.read_strobe && !read_was_; }
  bool starts(const In& in) const {
    return state_ == State::kRest && (in.read ? read_rises(in) : write_rises(in));
  }
  void enter(State state, std::uint32_t clocks) {
    state_ = state;
    timer_.step({true, clocks - 1});
  }

  Timer timer_;
  State state_ = State::kRest;
  Pins pins_;
  bool change_ = false;
  bool write_was_ = false, read_was_ = false;
  std::uint8_t byte_ = 0;
};

}  // namespace trammel::exact
