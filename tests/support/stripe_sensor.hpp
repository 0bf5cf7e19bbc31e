// SPDX-License-Identifier: Apache-2.0
//
// Codes of a stripe sensor with sine, cosine and their derivatives, ideal or with errors, and the
// calibration data that go with an ideal one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "models/exact/sense/calibration.hpp"

namespace trammel::test {

inline constexpr double kPeriod_mm = 5, kPi = 3.14159265358979323846;
inline constexpr double kUnit_mm = kPeriod_mm / 16384;
inline constexpr double kTick_s = 1 / 4612.0;

struct StripeSensor {
  double amplitude_a = 400, amplitude_b = 400;  // [code]
  double offset_a = 0, offset_b = 0;            // [code]
  double phase_b = 0;                           // [rad]
  double dot_full_mm_s = 500;                   // speed that gives 500 codes of derivative

  // Codes at a position and a speed; channels 0 A, 1 dA/dt, 2 B, 3 dB/dt, 6 current.
  int code(int channel, double x_mm, double v_mm_s) const {
    const double angle = 2 * kPi * x_mm / kPeriod_mm, dot = 500 * v_mm_s / dot_full_mm_s;
    switch (channel) {
      case 0: return rounded(512 + offset_a + amplitude_a * std::cos(angle));
      case 1: return rounded(512 - dot * std::sin(angle));
      case 2: return rounded(512 + offset_b + amplitude_b * std::sin(angle + phase_b));
      case 3: return rounded(512 + dot * std::cos(angle + phase_b));
      default: return 512;
    }
  }
  static int rounded(double code) {
    return static_cast<int>(std::clamp(std::round(code), 0.0, 1023.0));
  }
};

// Of an ideal sensor of amplitude 400 (specification of the observer).
inline exact::Calibration ideal_calibration() {
  exact::Calibration c;
  const auto put = [&c](std::size_t at, std::initializer_list<int> words) {
    for (const int word : words) c.words[at++] = static_cast<std::uint16_t>(word & 0xFFFF);
  };
  put(0, {'I' | 'D' << 8, 'E' | 'A' << 8, 'L' | ' ' << 8, 0});
  put(4, {512, 512});
  put(6, {2048, 6144, 10240, 14336});
  put(10, {0, 0, 0, 0});
  put(14, {162, 0, 1652, 1, -162, 0, -1652, 4097, -162, 0, -1652, 8193, 162, 0, 1652, 12289});
  put(30, {0, 512, 512, 12, 12, 1012, 1012});
  put(37, {0, 4096, 8192, 12288});
  for (const std::size_t region : {0u, 1u, 2u, 3u}) {
    const int sign = region == 0 || region == 3 ? 1 : -1;
    put(41 + 5 * region, {sign * 21885, 0, sign * 13736, 0, sign * 11641});
  }
  put(61, {13});
  return exact::sealed(c);
}

}  // namespace trammel::test
