// SPDX-License-Identifier: Apache-2.0
//
// The only place for shifts, rounding and saturation. Integers only.
// Twin of rtl/math/math_pkg.sv, function by function.
#pragma once

#include <cstdint>

namespace trammel::fixed {

// Clips x to a two's complement word of `bits` bits.
constexpr std::int64_t sat(std::int64_t x, int bits) {
  const std::int64_t top = (std::int64_t{1} << (bits - 1)) - 1;
  return x > top ? top : x < -top - 1 ? -top - 1 : x;
}

constexpr std::int64_t clip(std::int64_t x, std::int64_t low, std::int64_t high) {
  return x < low ? low : x > high ? high : x;
}

// Arithmetic shift right without rounding (floor).
constexpr std::int64_t floor_shift(std::int64_t x, int s) { return x >> s; }

constexpr std::int64_t shift_left(std::int64_t x, int s) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(x) << s);
}

// Shift right by s, rounded half up; shift left by -s for s <= 0 (specification section 3).
constexpr std::int64_t rs(std::int64_t x, int s) {
  return s > 0 ? (x + (std::int64_t{1} << (s - 1))) >> s : shift_left(x, -s);
}

// The low `bits` bits of x, read as a two's complement word (what a register of that width keeps).
constexpr std::int64_t wrap(std::int64_t x, int bits) {
  const int s = 64 - bits;
  return shift_left(x, s) >> s;
}

// value = mant / 2048 * 2^exp; mant 0..2047, exp -16..15.
struct Gain {
  std::int32_t mant = 0;
  std::int32_t exp = 0;

  constexpr double value() const {
    double v = mant / 2048.0;
    for (int i = 0; i < exp; ++i) v *= 2;
    for (int i = 0; i > exp; --i) v /= 2;
    return v;
  }
};

}  // namespace trammel::fixed
