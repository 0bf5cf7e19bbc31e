// SPDX-License-Identifier: Apache-2.0
//
// Keys of machines with an LM628 and a DC motor. Included only where a table is made.
#pragma once

#include "lab/key_table.hpp"

namespace trammel::lm628 {

template <class Options>
void add_filter(lab::KeyTable<Options>& t) {
  t.one("filter.kp", 0, 32767, "of the error", TRAMMEL_LENS(filter.kp));
  t.one("filter.ki", 0, 32767, "of the sum of errors / 256", TRAMMEL_LENS(filter.ki));
  t.one("filter.kd", 0, 32767, "of the change of the error", TRAMMEL_LENS(filter.kd));
  t.one("filter.il", 0, 32767, "limit of the integral term", TRAMMEL_LENS(filter.il));
  t.one("filter.interval_samples", 1, 256, "of the derivative term",
        TRAMMEL_LENS(filter.interval));
}

// `motor` selects the plant::DcMotorConfig of the Options.
template <class Options, class Lens>
void add_motor(lab::KeyTable<Options>& t, Lens motor) {
  const auto add = [&](const char* name, double min, double max, const char* help, auto member) {
    t.one(name, min, max, help,
          [motor, member](auto& o) -> auto& { return motor(o).*member; });
  };
  using M = plant::DcMotorConfig;
  add("motor.resistance_ohm", 0.01, 1000, "of the winding; assumed", &M::resistance);
  add("motor.inductance_H", 1e-4, 1, "of the winding; assumed", &M::inductance);
  add("motor.constant_N_m_A", 1e-3, 10, "torque of a current, and V s/rad; assumed", &M::constant);
  add("motor.inertia_kg_m2", 1e-6, 1, "of rotor and load; assumed", &M::inertia);
  add("motor.viscous_N_m_s", 0, 1, "viscous friction, per rad/s; assumed", &M::viscous);
  add("motor.coulomb_N_m", 0, 1, "Coulomb friction", &M::coulomb);
  add("motor.friction_speed_rad_s", 1e-3, 10, "where friction smooths out", &M::friction_speed);
  add("motor.external_torque_N_m", -10, 10, "against positive motion", &M::external_torque);
  add("motor.supply_V", 1, 100, "of the amplifier, at full scale of the converter; assumed",
      &M::supply);
}

}  // namespace trammel::lm628
