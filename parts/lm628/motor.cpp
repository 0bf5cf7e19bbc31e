// SPDX-License-Identifier: Apache-2.0
#include "parts/lm628/motor.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/errors.hpp"

namespace trammel::lm628 {

void check_motor(const plant::DcMotorConfig& c) {
  constexpr double kFastest = 1e5;  // [1/s], for steps of 16 us
  const auto check = [](const char* of, double rate) {
    if (rate <= kFastest) return;
    throw host::ConfigError(fmt::format(
        "{}: {:g} 1/s is above 1e5 1/s, the fastest that the motor's steps of 16 us can follow",
        of, rate));
  };
  check("motor.resistance_ohm / motor.inductance_H", c.resistance / c.inductance);
  check("motor friction / motor.inertia_kg_m2",
        (c.viscous + c.coulomb / c.friction_speed) / c.inertia);
  check("motor.constant_N_m_A / sqrt(motor.inductance_H motor.inertia_kg_m2)",
        c.constant / std::sqrt(c.inductance * c.inertia));
}

}  // namespace trammel::lm628
