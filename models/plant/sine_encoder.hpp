// SPDX-License-Identifier: Apache-2.0
//
// Rotary encoder with sinusoidal outputs and a marker once per revolution, behind comparators with
// a small hysteresis (McAfee 1994, ch. IV: 0.5 V around 2.5 V, LM339). Line A is the comparator of
// the cosine and B that of the sine, so that A leads B when the angle grows, and an LM628 counts
// up; with the two swapped it counts down. At angle 0 both lines are low, and so is the marker, for
// one line of the disc: an LM628 takes an index where all three are low, once per revolution.
#pragma once

#include <cmath>
#include <cstdint>

#include "models/plant/trig.hpp"

namespace trammel::plant {

struct SineEncoderConfig {
  int lines = 200;            // per revolution; four counts each
  double amplitude = 0.5;     // [V]
  double centre = 2.5;        // [V], also the comparators' threshold
  double hysteresis = 0.02;   // [V], full width, below twice the amplitude
  double cosine_offset = 0;   // [V], error of the channel's centre
  double sine_offset = 0;     // [V]
  bool swapped = false;       // sine on A
};

class SineEncoder {
 public:
  struct Signals {
    double cosine = 0, sine = 0, marker = 0;  // [V]
  };

  explicit SineEncoder(const SineEncoderConfig& c) : c_(c) { now_ = levels(0); }

  bool a() const { return c_.swapped ? now_.sine : now_.cosine; }
  bool b() const { return c_.swapped ? now_.cosine : now_.sine; }
  bool marker() const { return now_.marker; }  // active low
  std::int64_t count() const { return count_; }  // grows with the angle, swapped or not
  int counts() const { return 4 * c_.lines; }  // per revolution

  Signals signals(double theta) const {
    const double turns = theta / (2 * kPi);
    const SinCos line = sin_cos_turns(turns * c_.lines + kBothLow);
    const double lines_off = (turns - std::floor(turns + 0.5)) * c_.lines;
    const double dip = std::fmax(-1, 1 - 2 * std::fabs(lines_off));
    return {c_.centre + c_.cosine_offset + c_.amplitude * line.cos,
            c_.centre + c_.sine_offset + c_.amplitude * line.sin, c_.centre - c_.amplitude * dip};
  }

  bool leaves(double theta) const {
    const Levels l = levels(theta);
    return l.cosine != now_.cosine || l.sine != now_.sine || l.marker != now_.marker;
  }

  void follow(double theta) {
    const Levels l = levels(theta);
    if (l.cosine != now_.cosine) count_ += l.cosine != l.sine ? 1 : -1;
    if (l.sine != now_.sine) count_ += l.cosine == l.sine ? 1 : -1;
    now_ = l;
  }

 private:
  struct Levels {
    bool cosine = false, sine = false, marker = false;
  };
  static constexpr double kBothLow = 0.625;  // [lines] middle of the quarter in which both are low

  bool level(double volt, bool was) const {
    return volt > c_.centre + (was ? -0.5 : 0.5) * c_.hysteresis;
  }
  Levels levels(double theta) const {
    const Signals s = signals(theta);
    return {level(s.cosine, now_.cosine), level(s.sine, now_.sine), level(s.marker, now_.marker)};
  }

  SineEncoderConfig c_;
  Levels now_{};
  std::int64_t count_ = 0;
};

}  // namespace trammel::plant
