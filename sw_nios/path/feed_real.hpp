// SPDX-License-Identifier: Apache-2.0
//
// Positive numbers m 2^e with 64 bits of m, in integers only, so that the look-ahead of the feed
// profile reads as its formulas and every computer plans the same speeds. Results are truncated;
// a difference below 0 is 0. Not for a service routine: a quotient takes a small core some thousand
// clocks.
#pragma once

#include <cstdint>

namespace trammel::sw {

// Upper half of a 128-bit product.
constexpr std::uint64_t mul_high(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kLow = 0xFFFFFFFFu;
  const std::uint64_t low = (a & kLow) * (b & kLow);
  const std::uint64_t mid_a = (a >> 32) * (b & kLow);
  const std::uint64_t mid_b = (a & kLow) * (b >> 32);
  const std::uint64_t mid = (low >> 32) + (mid_a & kLow) + (mid_b & kLow);
  return (a >> 32) * (b >> 32) + (mid_a >> 32) + (mid_b >> 32) + (mid >> 32);
}

// a b 2^-right, which must fit 64 bits; right 1..63.
constexpr std::uint64_t mul_right(std::uint64_t a, std::uint64_t b, int right) {
  return mul_high(a, b) << (64 - right) | (a * b) >> right;
}

class Real {
 public:
  constexpr Real() = default;
  explicit Real(std::uint64_t value, int fraction = 0);  // value 2^-fraction

  // a/b, both above 0, for constants.
  static constexpr Real ratio(std::uint64_t a, std::uint64_t b) {
    Real r;
    for (; a >> 63 == 0; --r.e_) a <<= 1;
    r.m_ = a / b;
    for (; r.m_ >> 63 == 0; --r.e_) r.m_ <<= 1;
    return r;
  }

  // Nearest multiple of 2^-fraction; 2^64 - 1 of them above.
  std::uint64_t fixed(int fraction) const;

  friend Real operator*(const Real& a, const Real& b);
  friend Real operator/(const Real& a, const Real& b);  // b above 0
  friend Real operator+(const Real& a, const Real& b);
  friend Real operator-(const Real& a, const Real& b);
  friend Real sqrt(const Real& a);

  friend bool operator<(const Real& a, const Real& b);
  friend bool operator>(const Real& a, const Real& b) { return b < a; }
  friend bool operator<=(const Real& a, const Real& b) { return !(b < a); }

  constexpr bool zero() const { return m_ == 0; }

 private:
  static Real make(std::uint64_t m, int e);  // any m

  std::uint64_t m_ = 0;  // its highest bit set, or 0
  int e_ = 0;
};

inline Real min(const Real& a, const Real& b) { return b < a ? b : a; }
inline Real max(const Real& a, const Real& b) { return a < b ? b : a; }

}  // namespace trammel::sw
