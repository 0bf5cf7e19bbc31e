// SPDX-License-Identifier: Apache-2.0
//
// Codes of a sensor over stripes: sine, cosine and their derivatives, ideal or with errors of
// amplitude, offset and phase, with noise, and with two places where the stripes themselves are
// displaced (Brochier 2006, 3.3.2). The derivatives are those of the displaced stripes, so that a
// defect's edges show in the velocity more than in the position (figure 30).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "models/plant/noise.hpp"

namespace trammel::plant {

struct StripeTrackConfig {
  double period = 5e-3;                                         // [m]
  double amplitude = 400;                                       // [code]
  double amplitude_a_error = 0, amplitude_b_error = 0;          // share of the amplitude
  double offset_a_error = 0, offset_b_error = 0;                // share of the amplitude
  double phase_b_error = 0;                                     // [rad]
  double dot_codes = 500;                                       // [code] at dot_speed
  double dot_speed = 0.5;                                       // [m/s]
  std::array<double, 2> defect_at{0.190, 0.300};                // [m] their middles
  std::array<double, 2> defect_units{200, -200};                // [2^-14 period]; 0: none
  double defect_width = 2e-3;                                   // [m]
  double noise = 0, dot_noise = 0;                              // [code] rms
  std::uint64_t seed = 1;                                       // of the noise
};

class StripeTrack {
 public:
  static constexpr double kTurn = 6.283185307179586;  // [rad]
  static constexpr int kCentre = 512, kTop = 1023;    // [code]

  explicit StripeTrack(const StripeTrackConfig& config) : c_(config) {}

  const StripeTrackConfig& config() const { return c_; }

  // Where the stripes have it: the place, displaced within a defect; its edges are 0.1 mm wide.
  double seen(double x) const {
    double shift = 0;
    for (std::size_t k = 0; k < c_.defect_at.size(); ++k) {
      shift += c_.defect_units[k] * std::clamp(inside(k, x) / kEdge, 0.0, 1.0);
    }
    return x + shift * c_.period / 16384;
  }

  // d seen / dx: 1, but for the edges of a defect.
  double slope(double x) const {
    double shift = 0;
    for (std::size_t k = 0; k < c_.defect_at.size(); ++k) {
      const double in = inside(k, x), rise = x < c_.defect_at[k] ? 1 : -1;
      if (in > 0 && in < kEdge) shift += c_.defect_units[k] * rise / kEdge;
    }
    return 1 + shift * c_.period / 16384;
  }

  // At a place [m], a speed [m/s] and a clock, of which noise is a function; channels 0 A, 1 dA/dt,
  // 2 B, 3 dB/dt; others: the middle.
  int code(int channel, double x, double v, std::int64_t n = 0) const {
    const double angle = kTurn * seen(x) / c_.period;
    const double dot = c_.dot_codes * v * slope(x) / c_.dot_speed;
    const auto noisy = [&](double clean) {
      const double rms = channel % 2 == 0 ? c_.noise : c_.dot_noise;
      return rounded(rms == 0 ? clean : clean + rms * unit_noise(c_.seed, channel, n));
    };
    switch (channel) {
      case 0:
        return noisy(c_.amplitude *
                     (c_.offset_a_error + (1 + c_.amplitude_a_error) * std::cos(angle)));
      case 1: return noisy(-dot * (1 + c_.amplitude_a_error) * std::sin(angle));
      case 2:
        return noisy(c_.amplitude * (c_.offset_b_error + (1 + c_.amplitude_b_error) *
                                                             std::sin(angle + c_.phase_b_error)));
      case 3: return noisy(dot * (1 + c_.amplitude_b_error) * std::cos(angle + c_.phase_b_error));
      default: return kCentre;
    }
  }

 private:
  static constexpr double kEdge = 1e-4;  // [m]

  double inside(std::size_t k, double x) const {  // a defect [m]
    return c_.defect_width / 2 - std::fabs(x - c_.defect_at[k]);
  }

  static int rounded(double from_centre) {
    return static_cast<int>(std::clamp(std::round(kCentre + from_centre), 0.0, double{kTop}));
  }

  StripeTrackConfig c_;
};

}  // namespace trammel::plant
