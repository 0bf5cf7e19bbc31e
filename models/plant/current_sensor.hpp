// SPDX-License-Identifier: Apache-2.0
//
// Phase current sensor with its converter: offset binary, code = 2^(bits-1) + round(i / LSB),
// clipped; i is the current times a gain, plus an offset and noise. Noise is a pure function of
// (seed, channel, clock): another call gives the same value.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace trammel::plant {

struct CurrentSensorConfig {
  double full_scale = 9.6;  // [A]
  double noise = 0;         // [A] rms
  double offset = 0;        // [A] shown at no current
  double gain = 1;          // what is shown of the current
  int bits = 12;
};

inline std::uint64_t hash(std::uint64_t x) {  // splitmix64
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Nearly normal, mean 0, variance 1: the sum of twelve 16-bit uniform numbers, no libm.
inline double unit_noise(std::uint64_t seed, int channel, std::int64_t n) {
  std::uint64_t h =
      hash(seed ^ hash(static_cast<std::uint64_t>(channel) ^ hash(static_cast<std::uint64_t>(n))));
  std::int64_t sum = 0;
  for (int word = 0; word < 3; ++word) {
    for (int part = 0; part < 4; ++part) {
      sum += static_cast<std::int64_t>((h >> (16 * part)) & 0xffffu);
    }
    h = hash(h);
  }
  return (static_cast<double>(sum) + 6.0) / 65536.0 - 6.0;
}

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
