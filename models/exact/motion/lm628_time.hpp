// SPDX-License-Identifier: Apache-2.0
//
// Twin of rtl/motion/lm628_time.sv.
#pragma once

#include <cstdint>

#include "models/exact/math/timer.hpp"

namespace trammel::exact {

// Clock frequencies of the part, in ticks per 25 clocks of a 50 MHz fabric, or one of 20 MHz.
enum class Lm628Clock : std::uint32_t { k6MHz = 3, k8MHz = 4, k8MHzOf20 = 10 };

// Clocks for so many ticks, rounded up.
constexpr std::uint32_t lm628_clocks(Lm628Clock clock, std::uint32_t ticks) {
  const auto inc = static_cast<std::uint32_t>(clock);
  return (25 * ticks + inc - 1) / inc;
}

inline constexpr std::uint32_t kLm628Run = 128;  // [clk] for the execution of a command

class Lm628Time {
 public:
  explicit Lm628Time(Lm628Clock clock = Lm628Clock::k8MHz) : clock_(clock) { reset(); }

  void reset() {
    timer_.reset();
    state_ = State::kStart;
    rest_ = (25 * 8000 + inc() - 1) % inc();
  }

  bool begins() const { return state_ == State::kReset && timer_.count() == 0; }
  bool ready() const { return state_ != State::kStart && state_ != State::kReset; }
  bool open() const { return state_ == State::kSettle || state_ == State::kOpen; }
  bool sample() const { return state_ == State::kBefore && timer_.count() == 0; }
  bool commit() const { return state_ == State::kSettle && timer_.count() == 0; }

  bool quiescent() const { return timer_.count() != 0; }
  Gap next() const { return timer_.next({timer_.count() == 0, 0}); }
  void advance(Gap n) { timer_.advance(n); }

  void step() {
    if (timer_.count() != 0) {
      timer_.step({});
      return;
    }
    const std::uint32_t lead = 24 / inc() + 4;
    const std::uint32_t commit = lm628_clocks(clock_, 400);
    switch (state_) {
      case State::kStart:
        enter(State::kReset, lm628_clocks(clock_, 8000) - 1);
        break;
      case State::kReset:
        enter(State::kBefore, lead + 1);
        break;
      case State::kBefore:
        enter(State::kCompute, commit - kLm628Run - 2 - lead);
        break;
      case State::kCompute:
        enter(State::kSettle, kLm628Run + 1);
        break;
      case State::kSettle:
        enter(State::kOpen, kTicks / inc() - commit - kLm628Run - 1);
        break;
      case State::kOpen: {
        rest_ += kTicks % inc();
        const bool longer = rest_ >= inc();
        if (longer) rest_ -= inc();
        enter(State::kBefore, kLm628Run + 2 + lead + (longer ? 1 : 0));
        break;
      }
    }
  }

 private:
  enum class State { kStart, kReset, kBefore, kCompute, kSettle, kOpen };
  static constexpr std::uint32_t kTicks = 25 * 2048;

  std::uint32_t inc() const { return static_cast<std::uint32_t>(clock_); }

  void enter(State state, std::uint32_t clocks) {
    state_ = state;
    timer_.step({true, clocks - 1});
  }

  Lm628Clock clock_;
  Timer timer_;
  State state_ = State::kStart;
  std::uint32_t rest_ = 0;  // inc - 1 less what the times so far were rounded up by, in 1/inc
};

}  // namespace trammel::exact
