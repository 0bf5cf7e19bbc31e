// SPDX-License-Identifier: Apache-2.0
//
// Space vector modulation in double precision: the paper's sector form and the min-max formula
// (specification section 8). Voltages are fractions of V_dc / sqrt 3.
#pragma once

#include <algorithm>
#include <cmath>

#include "models/ideal/clarke_park.hpp"

namespace trammel::ideal {

struct OffTimes {
  double a = 0.5, b = 0.5, c = 0.5;  // fraction of the period in which the upper switch is off
  int sector = 0;
};

inline OffTimes svpwm(const AlphaBeta& v) {
  const double root3 = std::sqrt(3.0);
  const double x = v.beta;
  const double y = (v.beta + root3 * v.alpha) / 2;
  const double z = (v.beta - root3 * v.alpha) / 2;
  // Signs of v_a, v_b, v_c of Kung eq. 8: X, -Z, -Y
  const int sector = (x > 0 ? 1 : 0) + (z < 0 ? 2 : 0) + (y < 0 ? 4 : 0);
  double t1 = 0, t2 = 0;
  switch (sector) {
    case 1: t1 = z, t2 = y; break;
    case 2: t1 = y, t2 = -x; break;
    case 3: t1 = -z, t2 = x; break;
    case 4: t1 = -x, t2 = z; break;
    case 5: t1 = x, t2 = -y; break;
    case 6: t1 = -y, t2 = -z; break;
    default: break;
  }
  const double sum = t1 + t2;
  if (sum > 1) t1 /= sum, t2 /= sum;
  const double a = (1 - t1 - t2) / 2, b = a + t1, c = b + t2;
  switch (sector) {
    case 1: return {b, a, c, sector};
    case 2: return {a, c, b, sector};
    case 4: return {c, b, a, sector};
    case 5: return {c, a, b, sector};
    case 6: return {b, c, a, sector};
    default: return {a, b, c, sector};
  }
}

// Duty of the three phases by common-mode injection; valid inside the hexagon.
inline Phases min_max_duty(const AlphaBeta& v) {
  const Phases p = inverse_clarke(v);
  const double middle = (std::max({p.a, p.b, p.c}) + std::min({p.a, p.b, p.c})) / 2;
  const double scale = 1 / std::sqrt(3.0);  // V_dc / sqrt 3 to V_dc
  return {0.5 + (p.a - middle) * scale, 0.5 + (p.b - middle) * scale,
          0.5 + (p.c - middle) * scale};
}

}  // namespace trammel::ideal
