// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/motion/watchdog.sv. It counts ticks only, so it has no timer.
#pragma once

#include <cstdint>

namespace trammel::exact {

class Watchdog {
 public:
  struct In {
    bool tick_pos = false;
    bool kick = false;
    bool enable = false;
    std::uint16_t limit = 0;  // [2 kHz ticks], 0 = off
  };

  void reset() { state_ = State(); }

  bool step(const In& in) {
    state_ = after(in);
    return state_.bite;
  }

  bool bite() const { return state_.bite; }

  bool quiescent(const In& in) const {
    const State s = after(in);
    return s.count == state_.count && s.bite == state_.bite;
  }

 private:
  struct State {
    std::uint32_t count = 0;  // ticks since the last kick
    bool bite = false;
  };

  State after(const In& in) const {
    State s = state_;
    if (!in.enable) return State();
    if (in.kick || in.limit == 0) {
      s.count = 0;
    } else if (in.tick_pos && !s.bite) {
      if (s.count >= in.limit) {
        s.bite = true;
      } else {
        ++s.count;
      }
    }
    return s;
  }

  State state_;
};

}  // namespace trammel::exact
