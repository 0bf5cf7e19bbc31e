// SPDX-License-Identifier: Apache-2.0
//
// Noise as a pure function of (seed, channel, n): another call gives the same value.
#pragma once

#include <cstdint>

namespace trammel::plant {

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

}  // namespace trammel::plant
