// SPDX-License-Identifier: Apache-2.0
//
// Arithmetic of the path generators: lengths are counts in Q32 (64 bits), directions are vectors
// rotated in Q62. Integers only, so that every computer writes the same points; a revolution of
// 100 000 steps drifts by less than 0.0001 count.
#pragma once

#include <cstdint>

namespace trammel::sw {

struct Point {
  std::int32_t x = 0;  // [count]
  std::int32_t y = 0;  // [count]
};

constexpr bool operator==(Point a, Point b) { return a.x == b.x && a.y == b.y; }

using Q32 = std::int64_t;  // 2^-32 count

// Longest part (lap, arc, stroke) of a path, in steps: keeps accumulated rounding invisible.
inline constexpr std::uint32_t kMaxTicks = 1u << 20;

constexpr Q32 from_counts(std::int32_t counts) { return static_cast<Q32>(counts) * (Q32{1} << 32); }

// Nearest count; halves are rounded up.
constexpr std::int32_t to_counts(Q32 q) {
  return static_cast<std::int32_t>((q + (Q32{1} << 31)) >> 32);
}

struct Vec {
  Q32 x = 0;
  Q32 y = 0;
};

constexpr Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec from_counts(Point p) { return {from_counts(p.x), from_counts(p.y)}; }
constexpr Point to_counts(Vec v) { return {to_counts(v.x), to_counts(v.y)}; }

// Rotations by 90 degrees are exact.
constexpr Vec quarter_left(Vec v) { return {-v.y, v.x}; }
constexpr Vec quarter_right(Vec v) { return {v.y, -v.x}; }

constexpr std::uint64_t magnitude(std::int64_t a) {
  const auto bits = static_cast<std::uint64_t>(a);
  return a < 0 ? 0 - bits : bits;
}

// a * b / 2^62, nearest; the product must fit 64 bits. Four 32-bit products, as on a small core.
constexpr std::int64_t mul_q62(std::int64_t a, std::int64_t b) {
  const bool negative = (a < 0) != (b < 0);
  const std::uint64_t ua = magnitude(a);
  const std::uint64_t ub = magnitude(b);
  constexpr std::uint64_t kLow = 0xFFFFFFFFu;
  const std::uint64_t low = (ua & kLow) * (ub & kLow);
  const std::uint64_t mid_a = (ua >> 32) * (ub & kLow);
  const std::uint64_t mid_b = (ua & kLow) * (ub >> 32);
  const std::uint64_t mid = (low >> 32) + (mid_a & kLow) + (mid_b & kLow);
  const std::uint64_t high = (ua >> 32) * (ub >> 32) + (mid_a >> 32) + (mid_b >> 32) + (mid >> 32);
  const std::uint64_t lower = (mid << 32) | (low & kLow);
  const auto product =
      static_cast<std::int64_t>(((high << 2) | (lower >> 62)) + ((lower >> 61) & 1u));
  return negative ? -product : product;
}

struct Rotation {
  std::int64_t cos = std::int64_t{1} << 62;  // Q62
  std::int64_t sin = 0;                      // Q62

  // By 1/n of a revolution, n >= 4, from the series of exp(i angle): once per path, no table.
  static constexpr Rotation per_turn(std::uint32_t n) {
    constexpr std::int64_t kHalfPi = 0x6487ED5110B4611A;  // Q62
    const std::int64_t angle = kHalfPi / n * 4 + kHalfPi % n * 4 / n;
    Rotation r;
    std::int64_t term = r.cos;
    for (std::int64_t k = 1; term != 0; ++k) {
      term = mul_q62(term / k, angle);
      const std::int64_t signed_term = (k & 2) != 0 ? -term : term;
      if ((k & 1) != 0) {
        r.sin += signed_term;
      } else {
        r.cos += signed_term;
      }
    }
    return r;
  }

  constexpr Rotation inverse() const { return {cos, -sin}; }

  // Rotates v counter-clockwise.
  constexpr Vec operator()(Vec v) const {
    return {mul_q62(v.x, cos) - mul_q62(v.y, sin), mul_q62(v.x, sin) + mul_q62(v.y, cos)};
  }
};

}  // namespace trammel::sw
