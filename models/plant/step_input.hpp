// SPDX-License-Identifier: Apache-2.0
//
// The step and direction inputs of a stepper's translator, or of the pulse buffer before it. A
// pulse is a rising edge of step. It has a least width, and direction is stable for a set-up time
// before its rising edge and a hold time behind it. Of a pulse that breaches one of these the
// translator makes no step.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace trammel::plant {

// Larson (1974) does not say what his translators ask for: his pulses of half a period of 240 kHz
// are 2.08 us wide.
struct StepInputConfig {
  double width_s = 1e-6;
  double setup_s = 1e-6;
  double hold_s = 1e-6;
};

// A pulse that makes no step.
struct StepBreach {
  enum class Kind { kNone, kWidth, kSetup, kHold };
  std::int64_t edge = 0;
  Kind kind = Kind::kNone;
  std::int64_t clocks = 0;  // that the pulse, the set-up or the hold took
};

class StepInput {
 public:
  StepInput(const StepInputConfig& c, std::int64_t clock_ps)
      : width_(clocks(c.width_s, clock_ps)),
        setup_(clocks(c.setup_s, clock_ps)),
        hold_(clocks(c.hold_s, clock_ps)) {}

  struct Seen {
    int pulse = 0;   // +1 or -1: a step is to be made
    int taken = 0;   // +1 or -1: the last one is not, its pulse was too short
    StepBreach breach;
  };

  // Pins from clock n on.
  Seen at(std::int64_t n, bool step, bool forward) {
    using Kind = StepBreach::Kind;
    Seen seen;
    const auto take = [&](Kind kind) {
      seen.taken = pulse_;
      seen.breach = {n, kind, n - rose_};
      pulse_ = 0;
    };
    if (forward != forward_ && known_) turned_ = n;
    if (step_ && !step && pulse_ != 0 && n - rose_ < width_) take(Kind::kWidth);
    if (turned_ == n && pulse_ != 0 && n - rose_ < hold_) take(Kind::kHold);
    if (step && !step_) {
      rose_ = n;
      pulse_ = 0;
      if (turned_ != kNever && n - turned_ < setup_) {
        seen.breach = {n, Kind::kSetup, n - turned_};
      } else {
        seen.pulse = pulse_ = forward ? 1 : -1;
      }
    }
    step_ = step;
    forward_ = forward;
    known_ = true;
    return seen;
  }

 private:
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

  static std::int64_t clocks(double seconds, std::int64_t clock_ps) {
    return static_cast<std::int64_t>(std::ceil(1e12 * seconds / static_cast<double>(clock_ps) -
                                               1e-6));
  }

  std::int64_t width_, setup_, hold_;         // [clk]
  bool step_ = false, forward_ = false;
  bool known_ = false;                        // pins have been seen
  std::int64_t rose_ = 0, turned_ = kNever;   // last edges of step and direction
  int pulse_ = 0;                             // of the last rising edge, while it may be taken back
};

}  // namespace trammel::plant
