// SPDX-License-Identifier: Apache-2.0
//
// Fits the observer's polynomials from a run at constant force, in integers. The angle of a sample
// comes from its time between two rises of A through its middle, which are three quarters of a
// period; each quarter's cubic, of the encoder that is steep there, is a least-squares fit in
// X = x / 2^14 of (Brochier 2006, 2.2.4): phase = ((c3 X + c2) X + c1) X + c0. Freestanding.
#pragma once

#include <array>
#include <cstdint>

#include "sw_nios/apps/gantry/protocol.hpp"

namespace trammel::sw {

inline constexpr std::uint32_t kCalibrationWords = 63;  // with the checksum
using CalibrationWords = std::array<std::uint16_t, kCalibrationWords>;

// CRC-16/CCITT-FALSE of the first 62 words, the low byte of each first.
inline std::uint16_t checksum(const CalibrationWords& words) {
  std::uint32_t crc = 0xFFFF;
  for (std::uint32_t k = 0; k < 2 * (kCalibrationWords - 1); ++k) {
    crc = gantry_channel::crc_with(crc, words[k / 2] >> (k % 2 * 8) & 0xFFu);
  }
  return static_cast<std::uint16_t>(crc);
}

class CalibrationFit {
 public:
  static constexpr std::uint32_t kMost = 6000;  // samples: 1.3 s
  static constexpr std::uint32_t kPeriods = 12, kSkipped = 8;  // 60 mm behind 40 mm

  // A conversion at a tick: of A, else of B.
  void add(std::uint32_t tick, bool of_a, std::int32_t code) {
    if (number_ == kMost) return;
    samples_[number_++] = {tick, static_cast<std::int16_t>(code), of_a};
    if (of_a) {
      if (last_a_ >= 0 && last_a_ < kMiddle && code >= kMiddle) ++rises_;
      last_a_ = code;
    }
  }
  bool full() const { return number_ == kMost || rises_ > kPeriods + kSkipped + 1; }
  bool empty() const { return number_ == 0; }

  // False: the run was no steady motion over all its periods.
  bool fit(CalibrationWords& words) {
    origins();
    crossings();
    if (rise_count_ < kPeriods + 1) return false;
    write_constants(words);
    for (std::uint32_t region = 0; region < 4; ++region) {
      if (!fit_region(region, words)) return false;
    }
    words[kCalibrationWords - 1] = checksum(words);
    return true;
  }

 private:
  static constexpr std::int32_t kMiddle = 512;
  static constexpr std::int64_t kOne = std::int64_t{1} << 28;
  static constexpr std::int32_t kTurn = 16384, kOverlap = 100;
  static constexpr std::uint32_t kFine = 8;  // bits of time behind the tick, and of phase

  struct Sample {
    std::uint32_t tick = 0;
    std::int16_t code = 0;
    bool of_a = false;
  };

  // Halfway between the extremes, each the mean of those of the periods.
  void origins() {
    for (std::uint32_t channel = 0; channel < 2; ++channel) {
      const bool a = channel == 0;
      std::int64_t sum = 0;
      std::int32_t last = -1, low = 1023, high = 0, turns = 0;
      for (std::uint32_t k = 0; k < number_; ++k) {
        if (samples_[k].of_a != a) continue;
        const std::int32_t code = samples_[k].code;
        if (last >= 0 && last < kMiddle && code >= kMiddle) {
          if (turns++ > static_cast<std::int32_t>(kSkipped)) sum += low + high;
          low = 1023;
          high = 0;
        }
        low = code < low ? code : low;
        high = code > high ? code : high;
        last = code;
      }
      const std::int32_t used = turns - 1 - static_cast<std::int32_t>(kSkipped);
      const std::int64_t fine = used > 0 ? sum * 8 / used : 2 * kMiddle * 8;  // 16 a code
      (a ? origin_a_ : origin_b_) = static_cast<std::int32_t>(fine);
    }
  }

  // When A rises through its origin.
  void crossings() {
    std::uint32_t seen = 0;
    std::int32_t last = -1;
    std::uint32_t last_tick = 0;
    for (std::uint32_t k = 0; k < number_; ++k) {
      const Sample& s = samples_[k];
      if (!s.of_a) continue;
      const std::int32_t code = 16 * s.code;
      if (last >= 0 && last < origin_a_ && code >= origin_a_ && seen++ >= kSkipped &&
          rise_count_ <= kPeriods) {
        const auto share = (static_cast<std::int64_t>(origin_a_ - last) * (1 << kFine)) *
                           (s.tick - last_tick) / (code - last);
        rise_[rise_count_++] = (std::int64_t{last_tick} << kFine) + share;
      }
      last = code;
      last_tick = s.tick;
    }
  }

  // Phase of a time in 2^-8 units, 0 to 2^22; -1 outside of the run.
  std::int64_t phase_of(std::uint32_t tick) const {
    const std::int64_t t = std::int64_t{tick} << kFine;
    for (std::uint32_t k = 0; k + 1 < rise_count_; ++k) {
      if (t < rise_[k] || t >= rise_[k + 1]) continue;
      const std::int64_t share = (t - rise_[k]) * (std::int64_t{kTurn} << kFine) /
                                 (rise_[k + 1] - rise_[k]);
      return (share + (std::int64_t{3 * kTurn / 4} << kFine)) % (std::int64_t{kTurn} << kFine);
    }
    return -1;
  }

  bool fit_region(std::uint32_t region, CalibrationWords& words) const {
    std::int64_t power[7] = {}, right[4] = {}, count = 0;
    const auto centre = static_cast<std::int64_t>(region) * (kTurn / 4) << kFine;
    constexpr std::int64_t kFull = std::int64_t{kTurn} << kFine;
    for (std::uint32_t k = 0; k < number_; ++k) {
      const Sample& s = samples_[k];
      if (s.of_a != (region % 2 == 1)) continue;
      const std::int64_t phase = phase_of(s.tick);
      if (phase < 0) continue;
      const std::int64_t off = (phase - centre + kFull + kFull / 2) % kFull - kFull / 2;
      if (off > ((kTurn / 8 + kOverlap) << kFine) || off < -((kTurn / 8 + kOverlap) << kFine)) {
        continue;
      }
      ++count;
      const std::int64_t x = std::int64_t{s.code - kMiddle} * 64;
      std::int64_t xk = std::int64_t{1} << 14;
      for (std::uint32_t n = 0; n < 7; ++n) {
        power[n] += xk;
        if (n < 4) right[n] += xk * off >> 14;
        xk = xk * x >> 14;
      }
    }
    if (count < 40) return false;
    std::int64_t m[4][4], b[4], c[4];
    for (std::uint32_t r = 0; r < 4; ++r) {
      for (std::uint32_t n = 0; n < 4; ++n) m[r][n] = power[r + n] * (1 << 14) / count;
      b[r] = right[r] * (1 << 6) / count;
    }
    if (!solve(m, b, c)) return false;
    for (std::uint32_t n = 0; n < 4; ++n) {
      const std::int64_t whole = (c[n] + (1 << (kFine + 5))) >> (kFine + 6);
      const std::int64_t word = n == 0 ? whole + (centre >> kFine) : whole;
      words[17 + 4 * region - n] = static_cast<std::uint16_t>(word & 0xFFFF);
    }
    return true;
  }

  // Gauss; the matrix is positive and has 28 bits behind the point.
  static bool solve(std::int64_t (&m)[4][4], std::int64_t (&b)[4], std::int64_t (&c)[4]) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      if (m[k][k] <= 0) return false;
      for (std::uint32_t r = k + 1; r < 4; ++r) {
        const std::int64_t f = m[r][k] * kOne / m[k][k];
        for (std::uint32_t n = k; n < 4; ++n) m[r][n] -= f * m[k][n] / kOne;
        b[r] -= f * b[k] / kOne;
      }
    }
    for (std::uint32_t k = 4; k-- > 0;) {
      std::int64_t sum = b[k];
      for (std::uint32_t n = k + 1; n < 4; ++n) sum -= m[k][n] * c[n] / kOne;
      if (m[k][k] <= 0) return false;
      c[k] = sum * kOne / m[k][k];
    }
    return true;
  }

  void write_constants(CalibrationWords& words) const {
    words = {};
    words[0] = 'F' | 'I' << 8;
    words[1] = 'T';
    words[4] = static_cast<std::uint16_t>((origin_a_ + 8) / 16);
    words[5] = static_cast<std::uint16_t>((origin_b_ + 8) / 16);
    for (std::uint32_t k = 0; k < 4; ++k) {
      words[6 + k] = static_cast<std::uint16_t>(2048 + 4096 * k);
      words[37 + k] = static_cast<std::uint16_t>(4096 * k);
      const std::int32_t sign = k == 0 || k == 3 ? 1 : -1;
      words[41 + 5 * k] = static_cast<std::uint16_t>(sign * 21885);
      words[43 + 5 * k] = static_cast<std::uint16_t>(sign * 13736);
      words[45 + 5 * k] = static_cast<std::uint16_t>(sign * 11641);
    }
    words[31] = words[32] = 512;
    words[33] = words[34] = 12;
    words[35] = words[36] = 1012;
    words[61] = 13;
  }

  std::array<Sample, kMost> samples_{};
  std::array<std::int64_t, kPeriods + 1> rise_{};
  std::uint32_t number_ = 0, rises_ = 0, rise_count_ = 0;
  std::int32_t last_a_ = -1, origin_a_ = 0, origin_b_ = 0;
};

}  // namespace trammel::sw
