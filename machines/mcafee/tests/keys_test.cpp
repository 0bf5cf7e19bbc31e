// SPDX-License-Identifier: Apache-2.0
//
// Each key of the machine mcafee sets the member that it is named after, and no other.
#include <catch2/catch.hpp>

#include "machines/mcafee/machine.hpp"
#include "tests/support/key_members.hpp"

using namespace trammel;

TEST_CASE("mcafee: each key sets its own member") {
  using O = mcafee::Options;
  test::KeyMembers<O> m;
  m.add("program", [](const O& o) { return o.stage; });
  m.add("compare", [](const O& o) { return o.compare; });
  m.add("chip.clock_MHz", [](const O& o) { return o.clock_MHz; });
  m.add("chip.error_limit_counts", [](const O& o) { return o.error_limit; });
  m.add("chip.index_check", [](const O& o) { return o.index_check; });
  m.add("run.diverged_counts", [](const O& o) { return o.diverged_counts; });
  m.add("run.reached_counts", [](const O& o) { return o.reached_counts; });
  m.add("filter.kp", [](const O& o) { return o.filter.kp; });
  m.add("filter.ki", [](const O& o) { return o.filter.ki; });
  m.add("filter.kd", [](const O& o) { return o.filter.kd; });
  m.add("filter.il", [](const O& o) { return o.filter.il; });
  m.add("filter.interval_samples", [](const O& o) { return o.filter.interval; });
  m.add("path.kind", [](const O& o) { return o.path.kind; });
  m.add("path.side_mm", [](const O& o) { return o.path.side_mm; });
  m.add("path.radius_mm", [](const O& o) { return o.path.radius_mm; });
  m.add("path.row_mm", [](const O& o) { return o.path.row_mm; });
  m.add("path.kappa_max_1_mm", [](const O& o) { return o.path.kappa_max_1_mm; });
  m.add("path.preview_rows", [](const O& o) { return o.path.preview_rows; });
  m.add("track.speed", [](const O& o) { return o.speed; });
  m.add("track.least_speed", [](const O& o) { return o.least_speed; });
  m.add("track.velocity_shift", [](const O& o) { return o.velocity_shift; });
  m.add("trajectory.acceleration", [](const O& o) { return o.acceleration; });
  m.add("trajectory.velocity", [](const O& o) { return o.velocity; });
  m.add("trajectory.position_counts", [](const O& o) { return o.position; });
  m.add("trajectory.readings", [](const O& o) { return o.readings; });
  m.add("trajectory.wait_s", [](const O& o) { return o.wait_s; });
  m.add("motor.resistance_ohm", [](const O& o) { return o.stage_axis.motor.resistance; });
  m.add("motor.inductance_H", [](const O& o) { return o.stage_axis.motor.inductance; });
  m.add("motor.constant_N_m_A", [](const O& o) { return o.stage_axis.motor.constant; });
  m.add("motor.inertia_kg_m2", [](const O& o) { return o.stage_axis.motor.inertia; });
  m.add("motor.viscous_N_m_s", [](const O& o) { return o.stage_axis.motor.viscous; });
  m.add("motor.coulomb_N_m", [](const O& o) { return o.stage_axis.motor.coulomb; });
  m.add("motor.friction_speed_rad_s", [](const O& o) { return o.stage_axis.motor.friction_speed; });
  m.add("motor.external_torque_N_m", [](const O& o) { return o.stage_axis.motor.external_torque; });
  m.add("motor.supply_V", [](const O& o) { return o.stage_axis.motor.supply; });
  m.add("motor.current_limit_A", [](const O& o) { return o.stage_axis.motor.current_limit; });
  m.add("stage.pitch_m", [](const O& o) { return o.stage_axis.pitch; });
  m.add("stage.switch_low_m", [](const O& o) { return o.stage_axis.switch_low; });
  m.add("stage.switch_high_m", [](const O& o) { return o.stage_axis.switch_high; });
  m.add("stage.switch_hysteresis_m", [](const O& o) { return o.stage_axis.switch_hysteresis; });
  m.add("stage.overtravel_m", [](const O& o) { return o.stage_axis.overtravel; });
  m.add("encoder.lines", [](const O& o) { return o.stage_axis.encoder.lines; });
  m.add("encoder.hysteresis_V", [](const O& o) { return o.stage_axis.encoder.hysteresis; });
  m.add("encoder.cosine_offset_V", [](const O& o) { return o.stage_axis.encoder.cosine_offset; });
  m.add("encoder.sine_offset_V", [](const O& o) { return o.stage_axis.encoder.sine_offset; });
  m.add("encoder.swapped", [](const O& o) { return o.stage_axis.encoder.swapped; });
  CHECK(m.wrong() == "");
}
