// SPDX-License-Identifier: Apache-2.0
//
// Butterworth low-pass filters of order 1 and 2, by the bilinear transform with the corner where it
// is asked for (Brochier 2006, 2.2.4: 5 Hz at 100 Hz sampling):
//   H(s) = 1 / (s + 1)    H(s) = 1 / (s^2 + sqrt(2) s + 1),    s = (z - 1) / (c (z + 1))
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace trammel::ideal {

class Butterworth {
 public:
  // order 1 or 2; corner and sampling in Hz, the corner below half the sampling.
  Butterworth(int order, double corner, double sampling) {
    const double c = std::tan(3.14159265358979323846 * corner / sampling);
    if (order == 1) {
      const double d = 1 + c;
      b_ = {c / d, c / d, 0};
      a_ = {(c - 1) / d, 0};
      return;
    }
    const double d = 1 + std::sqrt(2.0) * c + c * c;
    b_ = {c * c / d, 2 * c * c / d, c * c / d};
    a_ = {2 * (c * c - 1) / d, (1 - std::sqrt(2.0) * c + c * c) / d};
  }

  double step(double in) {
    const double out = b_[0] * in + s_[0];
    s_[0] = b_[1] * in - a_[0] * out + s_[1];
    s_[1] = b_[2] * in - a_[1] * out;
    return out;
  }

 private:
  std::array<double, 3> b_{};
  std::array<double, 2> a_{}, s_{};
};

}  // namespace trammel::ideal
