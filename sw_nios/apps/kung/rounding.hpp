// SPDX-License-Identifier: Apache-2.0
//
// Rounding and saturation of firmware (docs/precision.md, section 3), in words of 32 and 64 bits.
#pragma once

#include <cstdint>

namespace trammel::sw {

// x / 2^s, nearest, halves up; s > 0.
constexpr std::int32_t rs(std::int32_t x, std::uint32_t s) {
  return (x + (std::int32_t{1} << (s - 1))) >> s;
}
constexpr std::int64_t rs(std::int64_t x, std::uint32_t s) {
  return (x + (std::int64_t{1} << (s - 1))) >> s;
}

constexpr std::int32_t clip(std::int32_t x, std::int32_t low, std::int32_t high) {
  return x < low ? low : x > high ? high : x;
}

// The nearest word of that many bits.
constexpr std::int32_t sat(std::int32_t x, std::uint32_t bits) {
  const std::int32_t top = (std::int32_t{1} << (bits - 1)) - 1;
  return clip(x, -top - 1, top);
}

constexpr std::int32_t add_sat(std::int32_t a, std::int32_t b) {
  constexpr std::int32_t kTop = 0x7FFFFFFF;
  if (b > 0 && a > kTop - b) return kTop;
  if (b < 0 && a < -kTop - b) return -kTop;
  return a + b;
}

// floor(a / b), b > 0
constexpr std::int32_t floor_div(std::int32_t a, std::int32_t b) {
  const std::int32_t q = a / b;
  return q - (q * b > a ? 1 : 0);
}

}  // namespace trammel::sw
