// SPDX-License-Identifier: Apache-2.0
//
// Trapezoidal velocity profile of the LM628 (data sheet SNVS781C, "Trajectory generation"): a new
// desired position every sample and an exact end; target, speed and mode may change in motion.
//
// Position in counts as 32.16 bits, speed in counts/sample and acceleration in counts/sample^2 as
// 16.16. D(w), the sum of all (w - k A) > 0, is the stopping distance from speed w. With
// n = floor(w / A) and remainder p, w + D(w) = (n + 1)(w + p) / 2: the RTL compares that, this file
// the sum.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "models/fixed/fixed.hpp"

namespace trammel::exact {

class Trapezoid {
 public:
  enum class Mode { kPosition, kVelocity, kSmoothStop };

  struct Config {
    std::int64_t acceleration = 0;  // 0..2^30 - 1
    std::int64_t velocity = 0;      // 0..2^30 - 1
    Mode mode = Mode::kPosition;
    bool forward = true;  // direction in velocity mode
  };

  struct State {
    std::int64_t position = 0;  // 48 bits, 16 of them fractional
    std::int64_t speed = 0;
    std::int64_t target = 0;  // 32 bits
  };

  State state;

  std::int64_t count() const { return state.position >> 16; }

  // One sample. Returns whether the move is finished.
  bool step(const Config& c) {
    switch (c.mode) {
      case Mode::kPosition:
        return toward_target(c);
      case Mode::kVelocity:
        advance(state.speed + fixed::clip((c.forward ? c.velocity : -c.velocity) - state.speed,
                                          -c.acceleration, c.acceleration));
        return false;
      case Mode::kSmoothStop:
        advance(state.speed - fixed::clip(state.speed, -c.acceleration, c.acceleration));
        if (state.speed == 0) state.target = count();
        return state.speed == 0;
    }
    return false;
  }

  // Distance from speed w, after this sample, to rest.
  static std::int64_t stopping(std::int64_t w, std::int64_t acceleration) {
    if (acceleration == 0) return 0;
    const std::int64_t n = w / acceleration;
    return n * w - acceleration * n * (n + 1) / 2;  // below 2^60, for A n <= w < 2^30
  }

 private:
  void advance(std::int64_t speed) {
    state.speed = speed;
    state.position = fixed::wrap(state.position + speed, 48);
  }

  std::int64_t goal() const { return fixed::shift_left(state.target, 16); }

  bool toward_target(const Config& c) {
    const std::int64_t rest = goal() - state.position;
    if (state.speed == 0 && (rest == 0 || c.acceleration == 0 || c.velocity == 0)) {
      state.target = count();
      return true;
    }
    const bool up = rest != 0 ? rest > 0 : state.speed > 0;
    const std::int64_t w = next_speed(c, std::abs(rest), up ? state.speed : -state.speed);
    advance(up ? w : -w);
    if (state.position != goal() || std::abs(state.speed) > 2 * c.acceleration) return false;
    state.speed = 0;
    return true;
  }

  // v: present speed toward the target, r: distance to it.
  static std::int64_t next_speed(const Config& c, std::int64_t r, std::int64_t v) {
    const std::int64_t a = c.acceleration;
    const std::int64_t least = std::min(a, c.velocity);
    const std::int64_t slower = std::max<std::int64_t>(v - a, 0);
    const auto stops = [&](std::int64_t w) { return w + stopping(w, a) <= r; };
    if (v < 0) return std::min<std::int64_t>(v + a, 0);
    if (0 < r && r <= least && v <= 2 * a) return r;
    if (v > c.velocity) {
      const std::int64_t w = std::max(v - a, c.velocity);
      return stops(w) ? w : slower;
    }
    std::int64_t w = std::min(v + a, c.velocity);
    if (!stops(w)) w = stops(v) ? v : slower;
    return w == 0 && r > 0 && v <= a ? least : w;
  }
};

}  // namespace trammel::exact
