// SPDX-License-Identifier: Apache-2.0
//
// Sine and cosine of an angle in revolutions from +, * and floor only: the same bits with every C
// library. Error below 2e-16 for |turns| < 1e6.
#pragma once

#include <cmath>

namespace trammel::plant {

inline constexpr double kPi = 3.14159265358979323846;

struct SinCos {
  double sin, cos;
};

inline SinCos sin_cos_turns(double turns) {
  const double quarters = 4.0 * turns;
  const double whole = std::floor(quarters + 0.5);
  const double a = (quarters - whole) * (kPi / 2);  // |a| <= pi/4
  const double z = a * a;
  double s = -1.0 / 1307674368000.0;  // Taylor to a^15 and a^16
  s = s * z + 1.0 / 6227020800.0;
  s = s * z - 1.0 / 39916800.0;
  s = s * z + 1.0 / 362880.0;
  s = s * z - 1.0 / 5040.0;
  s = s * z + 1.0 / 120.0;
  s = s * z - 1.0 / 6.0;
  s = a + a * z * s;
  double c = 1.0 / 20922789888000.0;
  c = c * z - 1.0 / 87178291200.0;
  c = c * z + 1.0 / 479001600.0;
  c = c * z - 1.0 / 3628800.0;
  c = c * z + 1.0 / 40320.0;
  c = c * z - 1.0 / 720.0;
  c = c * z + 1.0 / 24.0;
  c = c * z - 0.5;
  c = 1.0 + z * c;
  const double quadrant = whole - 4.0 * std::floor(whole * 0.25);
  if (quadrant == 0) return {s, c};
  if (quadrant == 1) return {c, -s};
  if (quadrant == 2) return {-s, -c};
  return {-c, s};
}

}  // namespace trammel::plant
