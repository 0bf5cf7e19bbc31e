// SPDX-License-Identifier: Apache-2.0
//
// Each key of the machine larson sets the member that it is named after, and no other.
#include <catch2/catch.hpp>

#include "machines/larson/machine.hpp"
#include "tests/support/key_members.hpp"

using namespace trammel;

TEST_CASE("larson: each key sets its own member") {
  using O = larson::Options;
  test::KeyMembers<O> m;
  m.add("table.soft_end_step", [](const O& o) { return o.table.soft_end; });
  m.add("table.margin_step", [](const O& o) { return o.table.margin; });
  m.add("table.seek_rate", [](const O& o) { return o.table.seek_rate; });
  m.add("table.back_rate", [](const O& o) { return o.table.back_rate; });
  m.add("table.most_rate", [](const O& o) { return o.table.most_rate; });
  m.add("table.poll_ms", [](const O& o) { return o.poll_ms; });
  m.add("table.settle_ms", [](const O& o) { return o.wttbl_ms; });
  m.add("plot.move_rate", [](const O& o) { return o.plot.move; });
  m.add("plot.draw_rate", [](const O& o) { return o.plot.draw; });
  m.add("axis.start_x_step", [](const O& o) { return o.start_x; });
  m.add("axis.start_y_step", [](const O& o) { return o.start_y; });
  m.add("axis.switch_low_step", [](const O& o) { return o.axis.switch_low; });
  m.add("axis.switch_high_step", [](const O& o) { return o.axis.switch_high; });
  m.add("axis.switch_hysteresis_step", [](const O& o) { return o.axis.switch_hysteresis; });
  m.add("axis.overtravel_step", [](const O& o) { return o.axis.overtravel; });
  m.add("axis.accuracy_step", [](const O& o) { return o.axis.platform.accuracy; });
  m.add("axis.repeatability_step", [](const O& o) { return o.axis.platform.repeatability; });
  m.add("axis.perpendicularity_arcsec", [](const O& o) { return o.perpendicularity_arcsec; });
  m.add("translator.width_us", [](const O& o) { return o.width_us; });
  m.add("translator.setup_us", [](const O& o) { return o.setup_us; });
  m.add("translator.hold_us", [](const O& o) { return o.hold_us; });
  m.add("buffer.fitted", [](const O& o) { return o.axis.buffer.fitted; });
  m.add("buffer.dead_s", [](const O& o) { return o.axis.buffer.dead_s; });
  m.add("buffer.start_rate", [](const O& o) { return o.axis.buffer.start; });
  m.add("buffer.rise", [](const O& o) { return o.axis.buffer.rise; });
  m.add("buffer.brake_rate", [](const O& o) { return o.axis.buffer.brake; });
  m.add("buffer.busy_above", [](const O& o) { return o.axis.buffer.busy_above; });
  m.add("buffer.idle_s", [](const O& o) { return o.axis.buffer.idle_s; });
  m.add("motor.inertia_kg_m2", [](const O& o) { return o.axis.motor.inertia; });
  m.add("motor.stiffness_2_N_m_rad", [](const O& o) { return o.axis.motor.stiffness_2; });
  m.add("motor.stiffness_3_N_m_rad", [](const O& o) { return o.axis.motor.stiffness_3; });
  m.add("motor.damping_2", [](const O& o) { return o.axis.motor.damping_2; });
  m.add("motor.damping_3", [](const O& o) { return o.axis.motor.damping_3; });
  m.add("motor.friction_N_m", [](const O& o) { return o.axis.motor.friction; });
  m.add("motor.friction_speed_step_s", [](const O& o) { return o.axis.motor.friction_speed; });
  m.add("motor.torque_share", [](const O& o) { return o.axis.motor.torque_share; });
  m.add("run.reached_steps", [](const O& o) { return o.reached_steps; });
  m.add("record.every_ms", [](const O& o) { return o.record_ms; });
  m.add("record.settle_s", [](const O& o) { return o.settle_s; });
  CHECK(m.wrong() == "");
}
