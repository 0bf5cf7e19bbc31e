// SPDX-License-Identifier: Apache-2.0
//
// Keys of the machine an693. Words of the trajectory are those that the LM628 takes.
#include "testbench/key_table.hpp"

namespace trammel::testbench {

template <>
std::vector<std::string> enum_names<sw::An693Program>() {
  return {"hold", "absolute", "relative", "breakpoints", "tuning"};
}

template <>
const std::vector<KeyOf<lm628::Options>>& keys_of<lm628::Options>() {
  static const auto all = [] {
    constexpr double kWord = 1073741823;  // 30 bits
    KeyTable<lm628::Options> t;
    t.names();
    t.text("program", "example of AN-693", TRAMMEL_LENS(program));
    t.platform_and_leap();
    t.window();
    t.longest_run();
    t.one("run.diverged_counts", 1, 32767, "position error that ends the run as diverged",
          TRAMMEL_LENS(run.diverged_counts));
    t.one("filter.kp", 0, 32767, "of the error", TRAMMEL_LENS(filter.kp));
    t.one("filter.ki", 0, 32767, "of the sum of errors / 256", TRAMMEL_LENS(filter.ki));
    t.one("filter.kd", 0, 32767, "of the change of the error", TRAMMEL_LENS(filter.kd));
    t.one("filter.il", 0, 32767, "limit of the integral term", TRAMMEL_LENS(filter.il));
    t.one("filter.interval_samples", 1, 256, "of the derivative term",
          TRAMMEL_LENS(filter.interval));
    t.one("trajectory.acceleration", 0, kWord, "2^-16 count/sample^2", TRAMMEL_LENS(acceleration));
    t.one("trajectory.velocity", 0, kWord, "2^-16 count/sample; of breakpoints the first speed",
          TRAMMEL_LENS(velocity));
    t.one("trajectory.position_counts", -kWord - 1, kWord, "target, distance, or size of a step",
          TRAMMEL_LENS(position));
    t.one("trajectory.breakpoint_counts", 1, 500000000, "the first; the second is as far from it",
          TRAMMEL_LENS(breakpoint));
    t.one("trajectory.steps", 1, 10000, "of tuning", TRAMMEL_LENS(steps));
    t.one("trajectory.wait_s", 1e-3, 60, "before STT, between steps, and at the end",
          TRAMMEL_LENS(wait_s));
    t.processor();
    t.one("motor.resistance_ohm", 0.01, 1000, "assumed", TRAMMEL_LENS(plant.motor.resistance));
    t.one("motor.inductance_H", 1e-4, 1, "assumed", TRAMMEL_LENS(plant.motor.inductance));
    t.one("motor.constant_N_m_A", 1e-3, 10, "torque of a current, and V s/rad; assumed",
          TRAMMEL_LENS(plant.motor.constant));
    t.one("motor.inertia_kg_m2", 1e-6, 1, "of rotor and load; assumed",
          TRAMMEL_LENS(plant.motor.inertia));
    t.one("motor.viscous_N_m_s", 0, 1, "friction a rad/s; assumed",
          TRAMMEL_LENS(plant.motor.viscous));
    t.one("motor.coulomb_N_m", 0, 1, "Coulomb friction", TRAMMEL_LENS(plant.motor.coulomb));
    t.one("motor.friction_speed_rad_s", 1e-3, 10, "where friction smooths out",
          TRAMMEL_LENS(plant.motor.friction_speed));
    t.one("motor.external_torque_N_m", -10, 10, "against positive motion",
          TRAMMEL_LENS(plant.motor.external_torque));
    t.one("motor.supply_V", 1, 100, "of the amplifier, at full scale of the converter; assumed",
          TRAMMEL_LENS(plant.motor.supply));
    t.one("encoder.counts", 4, 100000, "a turn, after x4 decoding", TRAMMEL_LENS(plant.counts));
    t.one("encoder.hysteresis_counts", 0, 0.9, "of its comparators",
          TRAMMEL_LENS(plant.hysteresis));
    return t.keys;
  }();
  return all;
}

}  // namespace trammel::testbench
