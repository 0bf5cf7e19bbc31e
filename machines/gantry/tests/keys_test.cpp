// SPDX-License-Identifier: Apache-2.0
//
// Each key of the machine gantry sets the member that it is named after, and no other; what its
// options may not be together.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "lab/layers.hpp"
#include "machines/gantry/machine.hpp"
#include "tests/support/key_members.hpp"
#include "tests/support/message.hpp"

using namespace trammel;

TEST_CASE("gantry: each key sets its own member") {
  using O = gantry::Options;
  test::KeyMembers<O> m;
  m.add("run.time_s", [](const O& o) { return o.time_s; });
  m.add("run.reached_mm", [](const O& o) { return o.reached_mm; });
  m.add("record.every_ms", [](const O& o) { return o.record_ms; });
  m.add("host.serial", [](const O& o) { return o.serial; });
  m.add("host.gap_ms", [](const O& o) { return o.gap_ms; });
  m.add("host.clip_goals", [](const O& o) { return o.firmware.clip_goals; });
  m.add("host.checked", [](const O& o) { return o.firmware.checked; });
  m.add("host.baud_error", [](const O& o) { return o.line.baud_error; });
  m.add("host.framing_errors", [](const O& o) { return o.line.framing_errors; });
  m.add("host.stream", [](const O& o) { return o.firmware.stream; });
  m.add("step.reference_mm", [](const O& o) { return o.reference_mm; });
  m.add("step.from_mm", [](const O& o) { return o.from_mm; });
  m.add("step.zero_mm", [](const O& o) { return o.zero_mm; });
  m.add("step.band_mm", [](const O& o) { return o.band_mm; });
  m.add("boot.home", [](const O& o) { return o.firmware.home; });
  m.add("boot.calibrate", [](const O& o) { return o.firmware.calibrate; });
  m.add("boot.home_force", [](const O& o) { return o.firmware.home_force; });
  m.add("boot.home_ticks", [](const O& o) { return o.firmware.home_ticks; });
  m.add("boot.fit_force", [](const O& o) { return o.firmware.fit_force; });
  m.add("monitor.stall_ticks", [](const O& o) { return o.firmware.stall_ticks; });
  m.add("monitor.sensor", [](const O& o) { return o.firmware.watch_sensor; });
  m.add("control.pass_ms", [](const O& o) { return o.pass_ms; });
  m.add("control.open", [](const O& o) { return static_cast<int>(o.firmware.open); });
  m.add("control.open_force", [](const O& o) { return o.firmware.open_force; });
  m.add("control.open_hold_ms", [](const O& o) { return o.open_hold_ms; });
  m.add("control.motors", [](const O& o) { return static_cast<int>(o.firmware.motors); });
  m.add("control.cascade", [](const O& o) { return o.firmware.cascade; });
  m.add("control.cascade_gain", [](const O& o) { return o.firmware.cascade_gain; });
  m.add("control.compensate", [](const O& o) { return o.firmware.compensate; });
  m.add("control.brake_force", [](const O& o) { return o.firmware.compensation.brake; });
  m.add("control.near_count", [](const O& o) { return o.firmware.compensation.near; });
  m.add("position.bang_bang", [](const O& o) { return o.firmware.position.bang; });
  m.add("position.sum", [](const O& o) { return static_cast<int>(o.firmware.position.sum); });
  m.add("position.sum_per_tick", [](const O& o) { return o.firmware.position.per_tick; });
  m.add("position.gain", [](const O& o) { return o.firmware.position.gain; });
  m.add("position.time_shift", [](const O& o) { return o.firmware.position.time; });
  m.add("position.max_force", [](const O& o) { return o.firmware.position.most; });
  m.add("position.min_force", [](const O& o) { return o.firmware.position.least; });
  m.add("position.aw_limit", [](const O& o) { return o.firmware.position.aw_limit; });
  m.add("velocity.gain_shift", [](const O& o) { return o.firmware.velocity.gain; });
  m.add("velocity.time_shift", [](const O& o) { return o.firmware.velocity.time; });
  m.add("velocity.sum_per_tick", [](const O& o) { return o.firmware.velocity.per_tick; });
  m.add("velocity.aw_limit", [](const O& o) { return o.firmware.velocity.aw_limit; });
  m.add("velocity.aw_shift", [](const O& o) { return o.firmware.velocity.aw_shift; });
  m.add("velocity.sum", [](const O& o) { return o.firmware.velocity.sum; });
  m.add("velocity.feed_forward", [](const O& o) { return o.firmware.velocity.feed_forward; });
  m.add("velocity.min_force", [](const O& o) { return o.firmware.velocity.least; });
  m.add("velocity.filter", [](const O& o) { return static_cast<int>(o.estimator.filter); });
  m.add("velocity.corner_Hz", [](const O& o) { return o.estimator.corner; });
  m.add("velocity.dead_samples", [](const O& o) { return o.estimator.dead_samples; });
  m.add("velocity.noise_mm_s", [](const O& o) { return o.estimator.noise; });
  m.add("velocity.doubt_count", [](const O& o) { return o.estimator.doubt; });
  m.add("axis.motor_1_left", [](const O& o) { return o.axis.left[0]; });
  m.add("axis.motor_1_right", [](const O& o) { return o.axis.right[0]; });
  m.add("axis.motor_2_left", [](const O& o) { return o.axis.left[1]; });
  m.add("axis.motor_2_right", [](const O& o) { return o.axis.right[1]; });
  m.add("axis.start_m", [](const O& o) { return o.axis.start; });
  m.add("axis.coulomb_count", [](const O& o) { return o.axis.coulomb; });
  m.add("axis.stiction_count", [](const O& o) { return o.axis.stiction; });
  m.add("axis.viscous_N_s_m", [](const O& o) { return o.axis.viscous; });
  m.add("axis.motor_mass_kg", [](const O& o) { return o.axis.motor_mass; });
  m.add("axis.cart_mass_kg", [](const O& o) { return o.axis.cart_mass; });
  m.add("axis.belt_N_m", [](const O& o) { return o.axis.belt_stiffness; });
  m.add("axis.belt_damping", [](const O& o) { return o.axis.belt_damping; });
  m.add("axis.gap_m", [](const O& o) { return o.axis.gap; });
  m.add("axis.zone_more", [](const O& o) { return o.axis.zone_more; });
  m.add("axis.winding_s", [](const O& o) { return o.axis.winding; });
  m.add("sensor.delay_s", [](const O& o) { return o.axis.delay; });
  m.add("sensor.amplitude_code", [](const O& o) { return o.stripes.amplitude; });
  m.add("sensor.amplitude_a_error", [](const O& o) { return o.stripes.amplitude_a_error; });
  m.add("sensor.amplitude_b_error", [](const O& o) { return o.stripes.amplitude_b_error; });
  m.add("sensor.offset_a_error", [](const O& o) { return o.stripes.offset_a_error; });
  m.add("sensor.offset_b_error", [](const O& o) { return o.stripes.offset_b_error; });
  m.add("sensor.phase_b_error_rad", [](const O& o) { return o.stripes.phase_b_error; });
  m.add("sensor.noise_code", [](const O& o) { return o.stripes.noise; });
  m.add("sensor.dot_noise_code", [](const O& o) { return o.stripes.dot_noise; });
  m.add("sensor.seed", [](const O& o) { return o.stripes.seed; });
  m.add("sensor.defect_1_unit", [](const O& o) { return o.stripes.defect_units[0]; });
  m.add("sensor.defect_2_unit", [](const O& o) { return o.stripes.defect_units[1]; });
  CHECK(m.wrong() == "");
}

TEST_CASE("gantry: two controls, or times, that exclude each other are refused") {
  const auto told = [](const std::string& toml) { return test::message_of<gantry::Options>(toml); };
  const std::string cascade = "[control]\ncascade = true\n", sum = "[position]\nsum = \"plain\"\n";
  CHECK(told(cascade + "compensate = true\n") == "");
  CHECK(told(sum) == "");
  CHECK_THAT(told("[position]\nbang_bang = true\n" + cascade),
             Catch::Contains("position.bang_bang: true, and control.cascade is true; permitted: "));
  CHECK_THAT(told(sum + cascade), Catch::Contains("position.sum: a sum, and control.cascade"));
  CHECK_THAT(told(sum + "bang_bang = true\n"),
             Catch::Contains("position.sum: a sum, and position.bang_bang"));
  CHECK_THAT(told("[control]\ncompensate = true\n"),
             Catch::Contains("control.compensate: true, and control.cascade is false; "));
  const auto assigned = [](const std::vector<std::string>& all) {
    return test::refusal_of([&all] {
      gantry::Options options;
      for (const std::string& one : all) lab::apply_assignment(options, one);
      lab::validate(options);
    });
  };
  CHECK(assigned({"run.time_s=1", "run.max_s=1"}) == "");
  CHECK(assigned({"run.max_s=1"}) == "");  // cuts the scenario's time
  CHECK(assigned({"run.time_s=1.5", "run.max_s=1"}) ==
        "run.time_s: 1.5 s is above run.max_s, 1 s; permitted: at most that");
  CHECK_THAT(assigned({"run.time_s=120.5"}), Catch::StartsWith("run.time_s: 120.5 s is above"));
}

TEST_CASE("gantry: forces that exclude each other are refused, each pair by its own keys") {
  const auto told = [](const std::string& toml) { return test::message_of<gantry::Options>(toml); };
  CHECK(told("") == "");
  CHECK(told("[axis]\ncoulomb_count = 90\nstiction_count = 90\n") == "");
  CHECK_THAT(told("[axis]\ncoulomb_count = 90.5\nstiction_count = 90\n"),
             Catch::EndsWith("axis.stiction_count: 90 is below axis.coulomb_count, 90.5; "
                             "permitted: at least that"));
  CHECK(told("[position]\nmin_force = 300\nmax_force = 300\n") == "");
  CHECK_THAT(told("[position]\nmin_force = 301\nmax_force = 300\n"),
             Catch::EndsWith("position.min_force: 301 is above position.max_force, 300; "
                             "permitted: at most that"));
  CHECK(told("[boot]\nhome = true\ncalibrate = true\n") == "");
  CHECK_THAT(told("[boot]\ncalibrate = true\n"),
             Catch::Contains("boot.calibrate: true, and boot.home is false; permitted: with "));
  CHECK_THAT(told("[host]\nsends = \"1:32=1\"\n"), Catch::Contains("host.sends: \"1:32=1\""));
}
