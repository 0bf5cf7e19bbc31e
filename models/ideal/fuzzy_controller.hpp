// SPDX-License-Identifier: Apache-2.0
//
// Adaptive fuzzy controller in double precision (Kung et al. 2012; specification section 5):
// triangular memberships, product inference, PI, speed gain and the tuning law. Quantities have
// the scale of the words (counts, 1/16 count per sample, I_fs / 4096) but are not quantised; the
// limits are those of the words.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace trammel::ideal {

class FuzzyController {
 public:
  struct Config {
    double kp = 768.0 / 2048;
    double ki = 839.0 / 2048 / 128;
    double kv = 1884.0 / 2048 * 2;
    double eta = 1140.0 / 2048 / 256;  // alpha (Kp + Ki) Kv / 32
    double e_unit = 256;               // [counts] of e per unit of the universe
    double de_unit = 64;               // [counts per sample] of de per unit
  };

  struct Out {
    double e = 0, de = 0, v = 0;
    double u = 0;        // 1/256 unit
    double v_star = 0;   // 1/16 count per sample
    double i_q_ref = 0;  // I_fs / 4096
  };

  FuzzyController() {
    for (std::size_t j = 0; j < 7; ++j) {
      for (std::size_t i = 0; i < 7; ++i) {
        // Kung eq. 19
        rules_[j][i] = std::clamp(2 * (static_cast<double>(i + j) - 6), -6.0, 6.0);
      }
    }
  }

  // Bumpless start at rest at x_p; the rules are kept.
  void reset(double x_p) {
    x_p_prev_ = x_p;
    e_prev_ = integral_ = 0;
  }

  // x_m: output of the reference model; x_p: position [counts].
  Out step(const Config& config, double x_m, double x_p) {
    Out out;
    out.e = word(x_m - x_p);  // Kung eq. 15
    out.de = word(out.e - e_prev_);  // Kung eq. 16
    out.v = word(16 * (x_p - x_p_prev_));
    const Membership a = fuzzify(out.e / config.e_unit);
    const Membership b = fuzzify(out.de / config.de_unit);
    const std::array<double, 4> d{a.low * b.low, a.high * b.low, a.low * b.high, a.high * b.high};
    const std::array<double*, 4> fired{
        &rules_[b.section][a.section], &rules_[b.section][a.section + 1],
        &rules_[b.section + 1][a.section], &rules_[b.section + 1][a.section + 1]};
    double units = 0;
    for (std::size_t n = 0; n < 4; ++n) units += *fired[n] * d[n];  // Kung eq. 20
    out.u = word(256 * units);
    integral_ = word(integral_ + config.ki * out.u);
    out.v_star = word(config.kp * out.u + integral_);
    out.i_q_ref = word(config.kv * word(out.v_star - out.v));
    for (std::size_t n = 0; n < 4; ++n) {
      // Kung eq. 27
      *fired[n] = std::clamp(*fired[n] + config.eta * out.e / 256 * d[n], -8.0, 8.0);
    }
    e_prev_ = out.e;
    x_p_prev_ = x_p;
    return out;
  }

  double rule(int index) const {  // [units], index 7 j + i
    return rules_[static_cast<std::size_t>(index / 7)][static_cast<std::size_t>(index % 7)];
  }

 private:
  struct Membership {
    std::size_t section = 0;
    double low = 0, high = 0;
  };

  static double word(double x) { return std::clamp(x, -2048.0, 2047.0); }

  static Membership fuzzify(double units) {
    const double from_lowest = (std::clamp(units, -6.0, 6.0) + 6) / 2;
    const double section = std::min(std::floor(from_lowest), 5.0);  // Kung eq. 17
    const double high = from_lowest - section;  // Kung eq. 18
    return {static_cast<std::size_t>(section), 1 - high, high};
  }

  std::array<std::array<double, 7>, 7> rules_{};
  double e_prev_ = 0, x_p_prev_ = 0;
  double integral_ = 0;
};

}  // namespace trammel::ideal
