// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/path/feed_real.hpp"

namespace trammel::sw {

Real Real::make(std::uint64_t m, int e) {
  Real r;
  if (m == 0) return r;
  for (int step = 32; step != 0; step >>= 1) {
    if (m >> (64 - step) != 0) continue;
    m <<= step;
    e -= step;
  }
  r.m_ = m;
  r.e_ = e;
  return r;
}

Real::Real(std::uint64_t value, int fraction) : Real(make(value, -fraction)) {}

std::uint64_t Real::fixed(int fraction) const {
  const int shift = e_ + fraction;
  if (m_ == 0 || shift < -64) return 0;
  if (shift > 0) return ~std::uint64_t{0};
  if (shift == 0) return m_;
  const std::uint64_t half = m_ >> (-shift - 1) & 1u;
  return shift == -64 ? half : (m_ >> -shift) + half;
}

bool operator<(const Real& a, const Real& b) {
  if (a.m_ == 0 || b.m_ == 0) return a.m_ < b.m_;
  return a.e_ != b.e_ ? a.e_ < b.e_ : a.m_ < b.m_;
}

Real operator*(const Real& a, const Real& b) {
  if (a.m_ == 0 || b.m_ == 0) return {};
  return Real::make(mul_high(a.m_, b.m_), a.e_ + b.e_ + 64);
}

Real operator/(const Real& a, const Real& b) {
  if (a.m_ == 0) return {};
  // a 2^63 / b in two digits of 32 bits (Knuth, algorithm D); the mantissa of a is halved, so that
  // it is below b's.
  constexpr std::uint64_t kLow = 0xFFFFFFFFu;
  const std::uint64_t high = b.m_ >> 32, low = b.m_ & kLow;
  std::uint64_t rest = a.m_ >> 1, quotient = 0;
  std::uint64_t next = (a.m_ & 1u) << 31;  // the digits that follow
  for (int digit = 0; digit < 2; ++digit) {
    std::uint64_t q = rest / high, r = rest - q * high;
    while (q > kLow || q * low > (r << 32 | next)) {
      --q;
      r += high;
      if (r > kLow) break;
    }
    rest = (rest << 32 | next) - q * b.m_;
    quotient = quotient << 32 | q;
    next = 0;
  }
  return Real::make(quotient, a.e_ - b.e_ - 63);
}

Real operator+(const Real& a, const Real& b) {
  if (a.m_ == 0) return b;
  if (b.m_ == 0) return a;
  if (a.e_ < b.e_) return b + a;
  const int shift = a.e_ - b.e_;
  if (shift > 63) return a;
  const std::uint64_t sum = a.m_ + (b.m_ >> shift);
  if (sum >= a.m_) return Real::make(sum, a.e_);
  return Real::make(sum >> 1 | std::uint64_t{1} << 63, a.e_ + 1);  // it carries
}

Real operator-(const Real& a, const Real& b) {
  if (a <= b) return {};
  const int shift = a.e_ - b.e_;
  return b.m_ == 0 || shift > 63 ? a : Real::make(a.m_ - (b.m_ >> shift), a.e_);
}

Real sqrt(const Real& a) {
  if (a.m_ == 0) return {};
  const int even = (a.e_ & 1) != 0 ? 1 : 2;
  std::uint64_t rest = a.m_ >> even, root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 62; bit != 0; bit >>= 2) {
    const bool one = rest >= root + bit;
    if (one) rest -= root + bit;
    root = (root >> 1) + (one ? bit : 0);
  }
  const Real first = Real::make(root, (a.e_ + even) / 2);  // 31 bits; a step of Newton doubles them
  const Real sum = first + a / first;
  return Real::make(sum.m_, sum.e_ - 1);
}

}  // namespace trammel::sw
