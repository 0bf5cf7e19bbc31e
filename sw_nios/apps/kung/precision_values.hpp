// SPDX-License-Identifier: Apache-2.0
//
// Words of the precision controller from the estimates of an axis (docs/precision.md, "Estimator").
// A gain is mant / 2048 2^exp.
#pragma once

#include <cstdint>

#include "sw_nios/apps/kung/estimator.hpp"
#include "sw_nios/apps/kung/gain.hpp"
#include "sw_nios/apps/kung/rounding.hpp"
#include "sw_nios/path/sine1024.hpp"

namespace trammel::sw {

// Of x > 0.
constexpr std::int32_t bit_length(std::int32_t x) {
  std::int32_t bits = 1;
  if (x >> 16 != 0) x >>= 16, bits += 16;
  if (x >> 8 != 0) x >>= 8, bits += 8;
  if (x >> 4 != 0) x >>= 4, bits += 4;
  if (x >> 2 != 0) x >>= 2, bits += 2;
  return bits + (x >> 1);
}

// The nearest gain of x / 2^point, x >= 0; below 2^-17 with less than 11 bits.
constexpr Gain normalized(std::int32_t x, std::int32_t point) {
  if (x == 0) return {};
  const std::int32_t bits = bit_length(x);
  const std::int32_t leading = bits > 12 ? x >> (bits - 12) : x << (12 - bits);
  Gain gain{(leading + 1) >> 1, bits - point};
  if (gain.mant == 2048) gain = {1024, gain.exp + 1};
  if (gain.exp < -16) {
    const std::int32_t lost = -16 - gain.exp;
    gain = {lost > 11 ? 0 : gain.mant >> lost, -16};
  }
  return gain;
}

// 1 / gain, of 11 bits.
constexpr Gain inverse(Gain gain) {
  const std::int32_t mant = (1 << 21) / gain.mant;
  return mant == 2048 ? Gain{1024, 2 - gain.exp} : Gain{mant, 1 - gain.exp};
}

// before / now - 1 [2^-15]; a mass changes by less than half from knot to knot.
constexpr std::int32_t mass_ratio(Gain before, Gain now) {
  const std::int32_t up = clip(15 + before.exp - now.exp, 0, 19);
  return sat((before.mant << up) / now.mant - 32768, 16);
}

// What a knot takes with its control point.
struct KnotWords {
  Gain km, kmi, kb;
  std::int32_t fc = 0;
};

constexpr KnotWords knot_words(const Estimator::Theta& theta, const EstimatorSetup& setup) {
  KnotWords words;
  words.km = normalized(theta[Estimator::kMass], 18 + static_cast<std::int32_t>(setup.accel_shift));
  words.kmi = inverse(words.km);
  words.kb =
      normalized(theta[Estimator::kViscous], 10 + static_cast<std::int32_t>(setup.speed_shift));
  words.fc = clip(rs(theta[Estimator::kCoulomb], 5), 0, 65535);
  return words;
}

// Cogging and constant force on the way between two points [2^-8 count], for IFF.
constexpr std::int32_t force_current(const Estimator::Theta& theta, std::int32_t from,
                                     std::int32_t to, std::int32_t pitch) {
  const std::int32_t at = floor_div(((3 * from + to) >> 2) * 32, pitch);
  const std::int64_t force = std::int64_t{theta[Estimator::kSine]} * sine1024(at) +
                             std::int64_t{theta[Estimator::kCosine]} * sine1024(at + 256) +
                             std::int64_t{1024} * theta[Estimator::kForce];
  const std::int64_t current = rs(force, 15);
  constexpr std::int32_t kMost = (1 << 19) - 1;
  return current > kMost ? kMost : current < -kMost ? -kMost : static_cast<std::int32_t>(current);
}

}  // namespace trammel::sw
