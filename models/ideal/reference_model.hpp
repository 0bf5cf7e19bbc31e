// SPDX-License-Identifier: Apache-2.0
//
// Reference model of the adaptive fuzzy controller: second order, bilinear transform, in the
// paper's five-multiplication form, for which double precision suffices and 24-bit words do not
// (specification section 4).
#pragma once

namespace trammel::ideal {

class ReferenceModel {
 public:
  struct Config {
    double omega_n = 30;  // [rad/s]
    double zeta = 1;
    double period = 0.5e-3;  // [s]
  };

  struct Coefficients {
    double a0, a1, a2, b1, b2;
  };

  ReferenceModel() : ReferenceModel(Config{}) {}
  explicit ReferenceModel(const Config& config) : c_(coefficients(config)) {}

  // Kung eq. 21 in the form of Kung eq. 23.
  static Coefficients coefficients(const Config& config) {
    const double k = 2 / config.period;
    const double w = config.omega_n;
    const double denominator = k * k + 2 * config.zeta * w * k + w * w;
    const double a0 = w * w / denominator;
    return {a0, 2 * a0, a0, 2 * (w * w - k * k) / denominator,
            (k * k - 2 * config.zeta * w * k + w * w) / denominator};
  }

  // At rest at x.
  void reset(double x) { x_1_ = x_2_ = r_1_ = r_2_ = x; }

  double step(double r) {
    // Kung eq. 24
    const double x = -c_.b1 * x_1_ - c_.b2 * x_2_ + c_.a0 * r + c_.a1 * r_1_ + c_.a2 * r_2_;
    x_2_ = x_1_;
    x_1_ = x;
    r_2_ = r_1_;
    r_1_ = r;
    return x;
  }

 private:
  Coefficients c_;
  double x_1_ = 0, x_2_ = 0, r_1_ = 0, r_2_ = 0;
};

}  // namespace trammel::ideal
