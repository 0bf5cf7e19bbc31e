// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace trammel::plant {

// Zero of a function of t in (0, length) that changes sign there.
template <class F>
double root(F f, double length) {
  double a = 0, b = length, f_a = f(0.0), f_b = f(length);
  for (int k = 0; k < 60 && b - a > 1e-13; ++k) {
    double t = k % 3 == 2 || f_a == f_b ? 0.5 * (a + b) : a - f_a * (b - a) / (f_b - f_a);
    if (!(t > a && t < b)) t = 0.5 * (a + b);
    const double f_t = f(t);
    if (f_t == 0) return t;
    if ((f_t > 0) == (f_a > 0)) {
      a = t;
      f_a = f_t;
    } else {
      b = t;
      f_b = f_t;
    }
  }
  return b;
}

}  // namespace trammel::plant
