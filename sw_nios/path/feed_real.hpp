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
  // value 2^-fraction
  constexpr explicit Real(std::uint64_t value, int fraction = 0) : m_(value), e_(-fraction) {
    normalize();
  }

  // Nearest multiple of 2^-fraction; 2^64 - 1 of them above.
  constexpr std::uint64_t fixed(int fraction) const {
    const int shift = e_ + fraction;
    if (m_ == 0 || shift < -64) return 0;
    if (shift > 0) return ~std::uint64_t{0};
    if (shift == 0) return m_;
    const std::uint64_t half = m_ >> (-shift - 1) & 1u;
    return shift == -64 ? half : (m_ >> -shift) + half;
  }

  friend constexpr Real operator*(Real a, Real b) {
    if (a.m_ == 0 || b.m_ == 0) return {};
    return make(mul_high(a.m_, b.m_), a.e_ + b.e_ + 64);
  }

  // b above 0.
  friend constexpr Real operator/(Real a, Real b) {
    if (a.m_ == 0) return {};
    std::uint64_t rest = a.m_, quotient = 0;
    for (int bit = 0; bit < 64; ++bit) {
      const bool carry = bit != 0 && rest >> 63 != 0;
      if (bit != 0) rest <<= 1;
      quotient <<= 1;
      if (carry || rest >= b.m_) {
        rest -= b.m_;
        quotient |= 1;
      }
    }
    return make(quotient, a.e_ - b.e_ - 63);
  }

  friend constexpr Real operator+(Real a, Real b) {
    if (a.m_ == 0) return b;
    if (b.m_ == 0) return a;
    if (a.e_ < b.e_) return b + a;
    const int shift = a.e_ - b.e_;
    if (shift > 63) return a;
    const std::uint64_t sum = a.m_ + (b.m_ >> shift);
    return sum >= a.m_ ? make(sum, a.e_) : make(sum >> 1 | std::uint64_t{1} << 63, a.e_ + 1);
  }

  friend constexpr Real operator-(Real a, Real b) {
    if (a <= b) return {};
    const int shift = a.e_ - b.e_;
    return b.m_ == 0 || shift > 63 ? a : make(a.m_ - (b.m_ >> shift), a.e_);
  }

  friend constexpr bool operator<(Real a, Real b) {
    if (a.m_ == 0 || b.m_ == 0) return a.m_ < b.m_;
    return a.e_ != b.e_ ? a.e_ < b.e_ : a.m_ < b.m_;
  }
  friend constexpr bool operator>(Real a, Real b) { return b < a; }
  friend constexpr bool operator<=(Real a, Real b) { return !(b < a); }

  constexpr bool zero() const { return m_ == 0; }

  friend constexpr Real sqrt(Real a) {
    if (a.m_ == 0) return {};
    const int even = (a.e_ & 1) != 0 ? 1 : 2;
    std::uint64_t rest = a.m_ >> even, root = 0;
    for (std::uint64_t bit = std::uint64_t{1} << 62; bit != 0; bit >>= 2) {
      const bool one = rest >= root + bit;
      if (one) rest -= root + bit;
      root = (root >> 1) + (one ? bit : 0);
    }
    const Real first = make(root, (a.e_ + even) / 2);  // 31 bits; a step of Newton doubles them
    const Real sum = first + a / first;
    return make(sum.m_, sum.e_ - 1);
  }

 private:
  static constexpr Real make(std::uint64_t m, int e) {
    Real r;
    r.m_ = m;
    r.e_ = e;
    r.normalize();
    return r;
  }

  constexpr void normalize() {
    if (m_ == 0) {
      e_ = 0;
      return;
    }
    for (int step = 32; step != 0; step >>= 1) {
      if (m_ >> (64 - step) == 0) {
        m_ <<= step;
        e_ -= step;
      }
    }
  }

  std::uint64_t m_ = 0;  // its highest bit set, or 0
  int e_ = 0;
};

constexpr Real min(Real a, Real b) { return b < a ? b : a; }
constexpr Real max(Real a, Real b) { return a < b ? b : a; }

}  // namespace trammel::sw
