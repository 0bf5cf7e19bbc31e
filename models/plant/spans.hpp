// SPDX-License-Identifier: Apache-2.0
//
// How long a span of a motor (pmlsm.hpp) may be: a tenth of the shortest time constant that winding
// and carriage have, so that its series to t^3 is stable and within 5e-6 of a transient; a quarter
// of that of friction near rest, M v_f/F_c, which is steep at rest only.
#pragma once

#include <algorithm>
#include <cmath>

#include "models/plant/pmlsm.hpp"

namespace trammel::plant {

inline constexpr double kShortestSpan = 5e-8;  // [s] what a run takes in bearable time

// What a motor does at rates [1/s].
struct MotorRates {
  double winding = 0;   // R/L
  double thrust = 0;    // winding and carriage against each other: K_F sqrt(2/(3 L M))
  double viscous = 0;   // B/M
  double friction = 0;  // F_c/(M v_f)
  double cogging = 0;   // of the carriage in a slot

  explicit MotorRates(const PmlsmConfig& m) {
    const double inductance = std::min(m.inductance_d, m.inductance_q);
    winding = m.resistance / inductance;
    thrust = m.force_constant * std::sqrt(2 / (3 * inductance * m.mass));
    viscous = m.viscous / m.mass;
    friction = (std::fabs(m.coulomb) + m.stribeck) / (m.mass * m.friction_speed);
    cogging = std::sqrt((std::fabs(m.cogging) + m.harmonic * std::fabs(m.harmonic_force)) * 2 *
                        kPi / (m.pole_pitch * m.mass));
  }

  // With the currents impressed, or with those of the winding.
  double carriage_span() const {
    return 1 / std::max({10 * viscous, 4 * friction, 10 * cogging});
  }
  double span() const { return std::min(carriage_span(), 0.1 / std::max(winding, thrust)); }
};

}  // namespace trammel::plant
