// SPDX-License-Identifier: Apache-2.0
//
// Cosine and sine of an angle of 32 bits, by their series: 13 products of 32 bits, no table. Exact
// at quarters of a turn; elsewhere within 2^-29.
#pragma once

#include <cstdint>

namespace trammel::sw {

struct CosSin {
  std::int32_t cos = 1 << 30;  // Q30
  std::int32_t sin = 0;        // Q30
};

namespace feed_sine {

constexpr std::uint32_t mul_high(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint32_t>(std::uint64_t{a} * b >> 32);
}

// 1/n! in Q32.
constexpr std::uint32_t part(std::uint64_t factorial) {
  return static_cast<std::uint32_t>(((std::uint64_t{1} << 33) / factorial + 1) / 2);
}

}  // namespace feed_sine

constexpr CosSin cos_sin(std::uint32_t angle) {  // [2^-32 turn]
  using feed_sine::mul_high;
  using feed_sine::part;
  const std::uint32_t quarter = (angle + (1u << 29)) >> 30;
  const auto rest = static_cast<std::int32_t>(angle - (quarter << 30));  // at most 1/8 turn
  const std::uint32_t size = rest < 0 ? 0u - static_cast<std::uint32_t>(rest)
                                      : static_cast<std::uint32_t>(rest);
  constexpr std::uint64_t kPi = 3373259426;  // Q30
  const auto x = static_cast<std::uint32_t>(size * kPi >> 29);  // [rad] Q32
  const std::uint32_t x2 = mul_high(x, x);
  std::uint32_t s = part(39916800);
  s = part(362880) - mul_high(s, x2);
  s = part(5040) - mul_high(s, x2);
  s = part(120) - mul_high(s, x2);
  s = part(6) - mul_high(s, x2);
  std::uint32_t c = part(479001600);
  c = part(3628800) - mul_high(c, x2);
  c = part(40320) - mul_high(c, x2);
  c = part(720) - mul_high(c, x2);
  c = part(24) - mul_high(c, x2);
  c = part(2) - mul_high(c, x2);
  const auto sine = static_cast<std::int32_t>((x - mul_high(x, mul_high(s, x2)) + 2) >> 2);
  const auto cosine = static_cast<std::int32_t>((1u << 30) - ((mul_high(c, x2) + 2) >> 2));
  const std::int32_t signed_sine = rest < 0 ? -sine : sine;
  switch (quarter & 3u) {
    case 0: return {cosine, signed_sine};
    case 1: return {-signed_sine, cosine};
    case 2: return {-cosine, -signed_sine};
    default: return {signed_sine, -cosine};
  }
}

}  // namespace trammel::sw
