// SPDX-License-Identifier: Apache-2.0
//
// Phase current sensor with its converter: offset binary, code = 2^(bits-1) + round(i / LSB),
// clipped; i is the current times a gain, plus an offset and noise.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "models/plant/noise.hpp"

namespace trammel::plant {

struct CurrentSensorConfig {
  double full_scale = 9.6;  // [A]
  double noise = 0;         // [A] rms
  double offset = 0;        // [A] shown at no current
  double gain = 1;          // what is shown of the current
  int bits = 12;
};

class CurrentSensor {
 public:
  explicit CurrentSensor(const CurrentSensorConfig& c)
      : half_(1 << (c.bits - 1)),
        per_amp_(half_ / c.full_scale),
        noise_(c.noise),
        offset_(c.offset),
        gain_(c.gain) {}

  int code(double current, std::uint64_t seed, int channel, std::int64_t n) const {
    current = gain_ * current + offset_;
    if (noise_ != 0) current += noise_ * unit_noise(seed, channel, n);
    const double steps = std::floor(current * per_amp_ + 0.5);
    const double top = half_ - 1;
    return half_ + static_cast<int>(std::clamp(steps, -static_cast<double>(half_), top));
  }

 private:
  int half_;
  double per_amp_;
  double noise_;
  double offset_;
  double gain_;
};

}  // namespace trammel::plant
