// SPDX-License-Identifier: Apache-2.0
//
// Incremental encoder of a scale [m] or shaft [rev]: count = floor(x/count + 0.5) with a symmetric
// hysteresis of `hysteresis` counts around each boundary; A leads B when counting up; the index is
// one count wide, once in each revolution of a shaft. Boundaries are where they belong but for a
// sine of the scale's period (a sub-divisional error) and for jitter, another one at each crossing,
// which stays within the hysteresis.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "models/plant/noise.hpp"
#include "models/plant/trig.hpp"

namespace trammel::plant {

struct EncoderConfig {
  double count = 5e-6;      // [m] per count, after x4 decoding
  double hysteresis = 0.2;  // [counts], full width
  double index = 0.25;      // [m]
  double error = 0;         // [m], amplitude of the sub-divisional error
  double period = 20e-6;    // [m], of the scale
  double jitter = 0;        // [m] rms
  std::uint64_t seed = 0;   // of the jitter
  std::int64_t turn = 0;    // [counts] from one index to the next; 0: the scale has one
};

class Encoder {
 public:
  Encoder(const EncoderConfig& c, double x) : c_(c), index_(nearest(c.index)), count_(nearest(x)) {
    set_limits();
    while (leaves(x)) follow(x);
  }

  std::int64_t count() const { return count_; }
  bool a() const { return ((count_ + 1) & 2) != 0; }
  bool b() const { return (count_ & 2) != 0; }
  bool z() const {
    return c_.turn == 0 ? count_ == index_ : (count_ - index_) % c_.turn == 0;
  }

  double low() const { return low_; }    // [m] below this the count falls
  double high() const { return high_; }  // [m] from here on the count rises
  bool leaves(double x) const { return x >= high_ || x < low_; }

  void follow(double x) {
    if (!leaves(x)) return;
    count_ += x >= high_ ? 1 : -1;
    ++crossings_;
    set_limits();
  }

 private:
  std::int64_t nearest(double x) const {
    return static_cast<std::int64_t>(std::floor(x / c_.count + 0.5));
  }
  void set_limits() {
    const double half = 0.5 + 0.5 * c_.hysteresis;
    low_ = (static_cast<double>(count_) - half) * c_.count;
    high_ = (static_cast<double>(count_) + half) * c_.count;
    if (c_.error != 0) {
      low_ += error(static_cast<double>(count_) - 0.5);
      high_ += error(static_cast<double>(count_) + 0.5);
    }
    if (c_.jitter != 0) {
      low_ += jitter(0);
      high_ += jitter(1);
    }
  }
  double error(double boundary) const {
    return c_.error * std::sin(2 * kPi * boundary * c_.count / c_.period);
  }
  double jitter(int side) const {
    const double most = 0.499 * c_.hysteresis * c_.count;
    return std::clamp(c_.jitter * unit_noise(c_.seed, side, crossings_), -most, most);
  }

  EncoderConfig c_;
  std::int64_t index_, count_;
  std::int64_t crossings_ = 0;
  double low_ = 0, high_ = 0;
};

}  // namespace trammel::plant
