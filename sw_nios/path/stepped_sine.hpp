// SPDX-License-Identifier: Apache-2.0
//
// Stepped sine on both axes at once, for frequency responses. A tone's period is a whole number of
// points and both its parts, settling and measured, are whole periods: sums over the second are
// exact, without a window. The periods fall in a geometric series, rounded; equal ones are played
// once. Begins and ends at the centre.
#pragma once

#include <cstdint>

#include "sw_nios/path/q32.hpp"

namespace trammel::sw {

class SteppedSine {
 public:
  struct Setup {
    Point center{60000, 60000};
    Vec amplitude{from_counts(100), from_counts(100)};
    std::uint32_t first_ticks = 500;   // period of the first tone, 4..kMaxTicks
    std::uint32_t ratio = 3428734206;  // of a period to the one before [2^-32]
    std::uint32_t tones = 19;          // at least 1
    std::uint32_t dwell_ticks = 200;   // least length of either part, 1..kMaxTicks
  };

  struct Tone {
    std::uint32_t period = 0;  // [points]
    std::uint32_t settle = 0;  // points before those that are measured, as many
  };

  // The tones of a sweep, one after the other.
  class Tones {
   public:
    constexpr explicit Tones(const Setup& setup)
        : ratio_(setup.ratio),
          dwell_(setup.dwell_ticks),
          left_(setup.tones),
          period_(static_cast<std::uint64_t>(setup.first_ticks) << kFraction) {}

    constexpr bool ended() const { return left_ == 0; }
    constexpr Tone tone() const {
      const std::uint32_t n = rounded();
      return {n, (dwell_ + n - 1) / n * n};
    }
    constexpr void next() {
      const std::uint32_t last = rounded();
      do {
        period_ = period_ * ratio_ >> 32;
        --left_;
      } while (left_ != 0 && rounded() == last);
    }

   private:
    static constexpr int kFraction = 10;

    constexpr std::uint32_t rounded() const {
      const auto n = static_cast<std::uint32_t>((period_ + (1u << (kFraction - 1))) >> kFraction);
      return n < 4 ? 4 : n;
    }

    std::uint64_t ratio_;
    std::uint32_t dwell_, left_;
    std::uint64_t period_;
  };

  constexpr explicit SteppedSine(const Setup& setup) : setup_(setup), tones_(setup) { begin(); }

  constexpr std::uint32_t size() const {
    std::uint32_t points = 1;
    for (Tones tones(setup_); !tones.ended(); tones.next()) points += 2 * tones.tone().settle;
    return points;
  }
  constexpr Point start() const { return setup_.center; }

  constexpr Point next() {
    const Point point{setup_.center.x + to_counts(mul_q62(setup_.amplitude.x, phase_.y)),
                      setup_.center.y + to_counts(mul_q62(setup_.amplitude.y, phase_.y))};
    if (tones_.ended()) return point;
    ++tick_;
    phase_ = tick_ % period_ == 0 ? kZero : step_(phase_);
    if (tick_ == length_) {
      tones_.next();
      begin();
    }
    return point;
  }

 private:
  static constexpr Vec kZero{std::int64_t{1} << 62, 0};

  constexpr void begin() {
    tick_ = 0;
    phase_ = kZero;
    if (tones_.ended()) return;
    const Tone tone = tones_.tone();
    period_ = tone.period;
    length_ = 2 * tone.settle;
    step_ = Rotation::per_turn(period_);
  }

  Setup setup_;
  Tones tones_;
  Rotation step_;
  Vec phase_ = kZero;  // cosine and sine, Q62
  std::uint32_t period_ = 4, length_ = 0, tick_ = 0;
};

}  // namespace trammel::sw
