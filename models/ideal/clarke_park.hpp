// SPDX-License-Identifier: Apache-2.0
//
// Clarke and Park transforms in double precision, amplitude-invariant (specification section 7).
#pragma once

#include <cmath>

namespace trammel::ideal {

struct AlphaBeta {
  double alpha = 0, beta = 0;
};
struct DirectQuadrature {
  double d = 0, q = 0;
};
struct Phases {
  double a = 0, b = 0, c = 0;
};

// Kung eq. 7; the third phase is -(a + b).
inline AlphaBeta clarke(double a, double b) { return {a, (a + 2 * b) / std::sqrt(3.0)}; }

inline Phases inverse_clarke(const AlphaBeta& v) {
  const double half_root3_beta = std::sqrt(3.0) / 2 * v.beta;
  return {v.alpha, -v.alpha / 2 + half_root3_beta, -v.alpha / 2 - half_root3_beta};
}

// Kung eq. 9
inline DirectQuadrature park(const AlphaBeta& v, double theta) {
  const double c = std::cos(theta), s = std::sin(theta);
  return {v.alpha * c + v.beta * s, -v.alpha * s + v.beta * c};
}

// Kung eq. 10
inline AlphaBeta inverse_park(const DirectQuadrature& v, double theta) {
  const double c = std::cos(theta), s = std::sin(theta);
  return {v.d * c - v.q * s, v.d * s + v.q * c};
}

}  // namespace trammel::ideal
