// SPDX-License-Identifier: Apache-2.0
#include "parts/lm628/motor.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/errors.hpp"

namespace trammel::lm628 {

void check_motor(const plant::DcMotorConfig& c) {
  constexpr double kFastest = 1e5;  // [1/s], for steps of 16 us
  const double electrical = c.resistance / c.inductance;
  const double mechanical = (c.viscous + c.coulomb / c.friction_speed) / c.inertia;
  if (electrical > kFastest || mechanical > kFastest) {
    throw lab::ConfigError(fmt::format(
        "{}: {:g} 1/s is above 1e5 1/s, the fastest that the motor's steps of 16 us can follow",
        electrical > kFastest ? "motor.resistance_ohm / motor.inductance_H"
                              : "motor friction / motor.inertia_kg_m2",
        std::max(electrical, mechanical)));
  }
}

}  // namespace trammel::lm628
