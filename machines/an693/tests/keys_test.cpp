// SPDX-License-Identifier: Apache-2.0
//
// Each key of the machine an693 sets the member that it is named after, and no other.
#include <catch2/catch.hpp>

#include "machines/an693/machine.hpp"
#include "tests/support/key_members.hpp"

using namespace trammel;

TEST_CASE("an693: each key sets its own member") {
  using O = an693::Options;
  test::KeyMembers<O> m;
  m.add("program", [](const O& o) { return o.program; });
  m.add("chip.variant", [](const O& o) { return o.part.variant; });
  m.add("chip.dac_bits", [](const O& o) { return o.part.dac_bits; });
  m.add("chip.clock_MHz", [](const O& o) { return o.part.clock_MHz; });
  m.add("chip.wrap", [](const O& o) { return o.part.wrap; });
  m.add("chip.error_limit_counts", [](const O& o) { return o.error_limit; });
  m.add("chip.index_check", [](const O& o) { return o.index_check; });
  m.add("run.diverged_counts", [](const O& o) { return o.diverged_counts; });
  m.add("run.reached_counts", [](const O& o) { return o.reached_counts; });
  m.add("filter.kp", [](const O& o) { return o.filter.kp; });
  m.add("filter.ki", [](const O& o) { return o.filter.ki; });
  m.add("filter.kd", [](const O& o) { return o.filter.kd; });
  m.add("filter.il", [](const O& o) { return o.filter.il; });
  m.add("filter.interval_samples", [](const O& o) { return o.filter.interval; });
  m.add("trajectory.acceleration", [](const O& o) { return o.acceleration; });
  m.add("trajectory.velocity", [](const O& o) { return o.velocity; });
  m.add("trajectory.position_counts", [](const O& o) { return o.position; });
  m.add("trajectory.breakpoint_counts", [](const O& o) { return o.breakpoint; });
  m.add("trajectory.steps", [](const O& o) { return o.steps; });
  m.add("trajectory.wait_s", [](const O& o) { return o.wait_s; });
  m.add("motor.resistance_ohm", [](const O& o) { return o.plant.motor.resistance; });
  m.add("motor.inductance_H", [](const O& o) { return o.plant.motor.inductance; });
  m.add("motor.constant_N_m_A", [](const O& o) { return o.plant.motor.constant; });
  m.add("motor.inertia_kg_m2", [](const O& o) { return o.plant.motor.inertia; });
  m.add("motor.viscous_N_m_s", [](const O& o) { return o.plant.motor.viscous; });
  m.add("motor.coulomb_N_m", [](const O& o) { return o.plant.motor.coulomb; });
  m.add("motor.friction_speed_rad_s", [](const O& o) { return o.plant.motor.friction_speed; });
  m.add("motor.external_torque_N_m", [](const O& o) { return o.plant.motor.external_torque; });
  m.add("motor.supply_V", [](const O& o) { return o.plant.motor.supply; });
  m.add("encoder.counts", [](const O& o) { return o.plant.counts; });
  m.add("encoder.hysteresis_counts", [](const O& o) { return o.plant.hysteresis; });
  CHECK(m.wrong() == "");
}
