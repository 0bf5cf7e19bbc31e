// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "machines/kung/plan.hpp"
#include "machines/kung/plan_parts.hpp"
#include "models/fixed/fixed.hpp"
#include "tests/support/points.hpp"

namespace {

using namespace trammel;
using namespace trammel::kung;
using Catch::Contains;

sw::KungSetup plan(const Options& options) {
  static std::vector<sw::Point> points;
  return plan_firmware(options, points);
}

Options with(PathKind kind) {
  Options o;
  o.path.kind = kind;
  return o;
}

bool equal(sw::Gain a, sw::Gain b) { return a.mant == b.mant && a.exp == b.exp; }

}  // namespace

TEST_CASE("the default options give the words of the specification") {
  const auto s = plan({});
  const sw::AxisSetup specified;
  for (const auto& axis : s.axis) {
    CHECK(fixed::Gain{axis.kp.mant, axis.kp.exp}.value() == 0.375);
    CHECK(fixed::Gain{axis.ki.mant, axis.ki.exp}.value() == Approx(0.0032).epsilon(0.0005));
    CHECK(fixed::Gain{axis.eta.mant, axis.eta.exp}.value() == Approx(0.00217).epsilon(0.003));
    CHECK(equal(axis.kv, specified.kv));
    CHECK(equal(axis.kp_cur, specified.kp_cur));
    CHECK(equal(axis.ki_cur, specified.ki_cur));
    CHECK(axis.a0 == 238008);
    CHECK(axis.b2 == 8140683);
    CHECK(axis.dead_time == 100);
    CHECK(axis.stroke_max == 120000);
    CHECK(axis.adapt);
  }
  CHECK(s.irq_period == 4);
  CHECK(s.current_limit == sw::KungSetup{}.current_limit);
}

TEST_CASE("path, strokes and electrical angle are in counts of the encoder that is there") {
  CHECK(plan({}).axis[0].angle_step == 352047);
  Options o;
  for (plant::AxisConfig& axis : o.plant.axis) axis.encoder_count_m = 10e-6;
  o.plant.axis[0].pole_pitch_m = 16e-3;  // 3200 counts an electrical turn
  o.plant.axis[1].pole_pitch_m = 40.96e-3;  // 8192
  sw::KungSetup s = plan(o);
  CHECK(s.axis[0].angle_step == 1342178);  // 2^32 / 3200 = 1342177.28, rounded up
  CHECK(s.axis[1].angle_step == 524288);
  CHECK(s.axis[0].stroke_max == 60000);
  CHECK(sw::Trajectory(s).start() == sw::Point{25000, 35000});
  o.path.circle_ticks = 123;  // at most 2.56 m/s
  CHECK_NOTHROW(plan(o));
  o.path.circle_ticks = 122;
  CHECK_THROWS_WITH(plan(o), Contains("feed at most 2.56 m/s"));
  o = {};
  o.plant.axis[1].pole_pitch_m = 39e-6;
  CHECK_THROWS_WITH(plan(o), Contains("plant.y.pole_pitch_m: value 3.9e-05 is 15.6 counts of "
                                      "plant.y.encoder_count_m an electrical turn"));
}

TEST_CASE("the reference model has its 18 bits at each frequency up to 200 rad/s") {
  const double kScale[] = {std::ldexp(1, -32), std::ldexp(1, -28), std::ldexp(1, -23)};
  for (const double omega : {1.0, 31.0, 31.5, 32.0, 60.0, 127.0, 128.0, 131.0, 200.0}) {
    for (const double zeta : {0.2, 1.0, 5.0}) {
      CAPTURE(omega, zeta);
      Options o;
      o.gains[0].omega_n_rad_s = omega;
      o.gains[0].zeta = zeta;
      const sw::AxisSetup axis = plan(o).axis[0];
      CHECK(axis.a0 < 1u << 18);
      // Bilinear transform of omega^2 / (s^2 + 2 zeta omega s + omega^2) at 2 kHz.
      const double k = 2 * 2000 / omega;
      const double a0 = axis.a0 * kScale[axis.a0_scale];
      CHECK(a0 == Approx(1 / (k * k + 2 * zeta * k + 1)).epsilon(omega < 2 ? 1e-2 : 1e-4));
    }
  }
  Options o;
  o.gains[0].omega_n_rad_s = 31;
  CHECK(plan(o).axis[0].a0_scale == 0);
  o.gains[0].omega_n_rad_s = 200;
  CHECK(plan(o).axis[0].a0_scale == 2);
}

TEST_CASE("limits and gains beyond the sensors that are there are refused with their range") {
  Options o;
  for (plant::AxisConfig& axis : o.plant.axis) axis.current_full_scale_a = 19.2;
  o.chip.current_limit_A = 19.2;
  CHECK_THROWS_WITH(plan(o), Contains("chip.current_limit_A: value 19.2 is out of range") &&
                                 Contains("at plant.x.current_full_scale_A = 19.2"));
  o.plant.axis[1].current_full_scale_a = 9.6;
  CHECK_THROWS_WITH(plan(o), Contains("plant.y.current_full_scale_A: value 9.6 must equal"));
  o = {};
  for (plant::AxisConfig& axis : o.plant.axis) axis.encoder_count_m = 1e-4;
  o.path.circle_ticks = 1000;
  o.gains[0].kv = 4;
  CHECK_THROWS_WITH(plan(o), Contains("gains.x.kv: value 4 is out of range 0..3.195 (at "
                                      "plant.x.encoder_count_m = 0.0001"));
}

TEST_CASE("the fixed controller does not learn") {
  Options o;
  o.controller = Controller::kFc;
  const auto s = plan(o);
  CHECK_FALSE(s.axis[0].adapt);
  CHECK(s.axis[0].eta.mant == 0);
}

TEST_CASE("the default paths in metres are the firmware's default paths") {
  const PathKind kinds[] = {PathKind::kCircle, PathKind::kWindow, PathKind::kStar,
                            PathKind::kSquare};
  const sw::Path paths[] = {sw::Path::kCircle, sw::Path::kWindow, sw::Path::kStar,
                            sw::Path::kSquare};
  const std::uint32_t sizes[] = {629, 1069, 911, 12000};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto s = plan(with(kinds[i]));
    sw::PathSetup d;
    d.path = paths[i];
    d.repeats = s.repeats;
    sw::Trajectory planned(s), specified(d);
    REQUIRE(planned.size() == sizes[i]);
    REQUIRE(specified.size() == sizes[i]);
    bool same = true;
    for (std::uint32_t k = 0; k < sizes[i]; ++k) same = same && planned.next() == specified.next();
    CHECK(same);
  }
  CHECK(plan(with(PathKind::kSquare)).irq_period == 1);
}

TEST_CASE("points become counts and stay with their owner") {
  Options o = with(PathKind::kPoints);
  o.path.points = {{0.1, 0.2}, {0.100005, 0.2}};
  std::vector<sw::Point> points;
  const auto s = plan_firmware(o, points);
  REQUIRE(points.size() == 2);
  CHECK(s.points == points.data());
  CHECK(points[1] == sw::Point{20001, 40000});
  o.path.repeats = 2;
  CHECK_THROWS_WITH(plan(o), Contains("path.repeats") && Contains("1..1"));
}

TEST_CASE("a step of the window is below the highest feed and half a straight part, each alone") {
  const double feed_m = Encoder{5e-6, 0.5e-3}.max_feed_m_s() * 2e-3;
  for (const double half_m : {feed_m / 2, 2 * feed_m}) {
    for (const bool beyond : {false, true}) {
      Options o;
      o.path.kind = PathKind::kWindow;
      o.path.window_side_m = 0.1;
      o.path.window_radius_m = 0.05 - half_m;
      o.path.window_arc_ticks = 5000;
      const double most_m = std::min(half_m, feed_m);
      o.path.window_step_m = most_m * (beyond ? 1.001 : 0.999);
      INFO("path.window_step_m = " << o.path.window_step_m << ", half a straight part " << half_m
                                   << ", highest feed " << feed_m);
      if (beyond) {
        CHECK_THROWS_WITH(plan(o), Contains("path.window_step_m"));
      } else {
        CHECK_NOTHROW(plan(o));
      }
    }
  }
}

TEST_CASE("values that cannot run are refused with their key and the permitted range") {
  Options o;
  o.path.circle_ticks = 245;  // 2 pi 100 mm in 245 * 2 ms = 1.282 m/s
  CHECK_THROWS_WITH(plan(o), Contains("path.circle_ticks: value 245") && Contains("246.."));
  o.path.circle_ticks = 246;
  CHECK_NOTHROW(plan(o));

  o = {};
  o.path.circle_center_x_m = 0.05;
  CHECK_THROWS_WITH(plan(o), Contains("path: x runs from -0.05 to 0.15 m, beyond the hard stops "
                                      "plant.x.stroke_min_m..stroke_max_m = 0..0.6"));
  o.plant.axis[0].hard_stops = false;
  CHECK_THROWS_WITH(plan(o), Contains("path: x runs from -0.05 to 0.15 m, beyond "
                                      "chip.x.stroke_min_m..stroke_max_m = 0..0.6"));
  o.chip.axis[0].stroke_min_m = -0.1;
  CHECK_NOTHROW(plan(o));
  o.plant.axis[0].encoder_count_m = 1e-6;
  CHECK_THROWS_WITH(plan(o), Contains("plant.y.encoder_count_m: value 5e-06 must equal "
                                      "plant.x.encoder_count_m = 1e-06"));

  o = with(PathKind::kWindow);
  o.path.window_radius_m = 0.1;
  CHECK_THROWS_WITH(plan(o), Contains("path.window_radius_m"));

  o = with(PathKind::kLine);
  o.path.line_ticks = 10;
  CHECK_THROWS_WITH(plan(o), Contains("path.line_ticks: value 10 ") && Contains("166..1048576"));

  o = {};
  o.chip.axis[0].stroke_max_m = 0.7;
  CHECK_THROWS_WITH(plan(o), Contains("chip.x.stroke_max_m: value 0.7 is out of range -0.65..0.65 "
                                      "(the chip's model reaches 130000 counts of "
                                      "plant.x.encoder_count_m = 5e-06)"));
  o = {};
  o.plant.axis[1].stroke_max_m = -1;
  CHECK_THROWS_WITH(plan(o), Contains("plant.y.stroke_min_m: must be below plant.y.stroke_max_m"));
  o = {};
  o.gains[1].current_kp_V_A = 1000;
  o.plant.axis[1].dc_link_v = 100;
  CHECK_THROWS_WITH(plan(o), Contains("gains.y.current_kp_V_A: value 1000 is out of range 0..") &&
                                 Contains("(at plant.y.dc_link_V = 100 and "));

  o = {};
  o.gains_by_rule = true;
  o.plant.axis[0].inductance_q_h = 1;
  CHECK_THROWS_WITH(plan(o), Contains("gains.x.current_kp_V_A: value 4000 is out of range 0..") &&
                                 Contains("(by gains.by_rule, at plant.x.dc_link_V = 311 and "));
  o.plant.axis[0] = {};
  o.plant.axis[0].force_constant_n_a = 1;
  o.plant.axis[0].mass_kg = 500;
  CHECK_THROWS_WITH(plan(o), Contains("gains.x.kv: value 29333.3 is out of range 0..63.9 (by "
                                      "gains.by_rule, at plant.x.encoder_count_m = 5e-06"));

  o = {};
  o.gains[1].interpolate = true;
  CHECK_NOTHROW(plan(o));
  o.chip.irq_period_ticks = 8;
  CHECK_THROWS_WITH(plan(o), Contains("gains.y.interpolate: must be off with "
                                      "chip.irq_period_ticks = 8: the chip reaches a point in 4 "
                                      "position samples"));
  o = with(PathKind::kSweep);
  o.gains[1].interpolate = true;
  CHECK_THROWS_WITH(plan(o), Contains("gains.y.interpolate: must be off in a sweep"));
  o = with(PathKind::kSquare);
  o.gains[1].interpolate = true;
  CHECK_NOTHROW(plan(o));
  o = {};
  o.chip.axis[1].dead_time_ns = 20'000;
  CHECK_NOTHROW(plan(o));
  o.chip.carrier_Hz = 40'000;
  CHECK_THROWS_WITH(plan(o), Contains("chip.y.dead_time_ns: value 20000 must be below 12500, half "
                                      "a period of chip.carrier_Hz = 40000"));
  o = {};
  o.plant.axis[1].resistance_ohm = 500;
  CHECK_NOTHROW(plan(o));
  o.plant.axis[1].inductance_d_h = 1e-4;
  CHECK_THROWS_WITH(plan(o), Contains("plant.y.resistance_ohm over inductance: a winding of 0.2 us "
                                      "is faster than the 0.5 us that the plant can follow"));
  o = {};
  o.plant.axis[0].coulomb_n = 500;
  o.plant.axis[0].friction_speed_m_s = 1e-5;
  CHECK_THROWS_WITH(plan(o), Contains("plant.x.friction_speed_m_s: friction that stops 2.5 kg in "
                                      "0.05 us is faster than the plant can follow"));
  o = {};
  o.plant.axis[0].force_constant_n_a = 10000;
  CHECK_NOTHROW(plan(o));
  o.plant.axis[0].inductance_q_h = 1e-4;
  o.plant.axis[0].resistance_ohm = 1;
  o.plant.axis[0].mass_kg = 0.1;
  o.gains[0].current_kp_V_A = o.gains[0].kv = 1;
  CHECK_THROWS_WITH(plan(o), Contains("plant.x.force_constant_N_A: 0.1 kg and the inductance swing "
                                      "against each other in 0.387 us, faster than the 0.5 us"));
  o = {};
  o.fault.kind = cosim::FaultKind::kBusStall;
  CHECK_NOTHROW(plan(o));
  o.cpu = Cpu::kRtl;
  CHECK_THROWS_WITH(plan(o), Contains("inject.fault: those of the processor and its bus need "
                                      "run.cpu = \"native\""));
  o.fault.kind = cosim::FaultKind::kGateDead;
  CHECK_NOTHROW(plan(o));
  o = {};
  o.plant.axis[1].chopper_v = 300;
  CHECK_THROWS_WITH(plan(o), Contains("plant.y.chopper_V: value 300 must be 0 or at least "
                                      "plant.y.dc_link_V = 311"));
  o.plant.axis[1].chopper_v = 311;
  CHECK_NOTHROW(plan(o));

  o = with(PathKind::kSweep);
  o.path.sweep_last_ticks = 501;
  CHECK_THROWS_WITH(plan(o), Contains("path.sweep_last_ticks: value 501 is out of range 4..500"));
  o = with(PathKind::kSweep);
  for (AxisGains& g : o.gains) g.omega_n_rad_s = 200;
  o.path.sweep_amplitude_m = 0.013;  // 100 / s of it is 1.3 m/s
  CHECK_THROWS_WITH(plan(o), Contains("path.sweep_amplitude_m: value 0.013 is out of range "
                                      "0..0.0128 (feed at most 1.28 m/s at "
                                      "plant.encoder_count_m = 5e-06)"));
  o.gains[0].omega_n_rad_s = 30;  // the faster axis still counts
  CHECK_THROWS_WITH(plan(o), Contains("path.sweep_amplitude_m: value 0.013"));
  o = with(PathKind::kSweep);
  o.gains[1].feedforward = true;
  CHECK_THROWS_WITH(plan(o), Contains("gains.y.feedforward: must be off in a sweep of position"));
  o.path.sweep_of = SweepOf::kCurrent;
  CHECK_THROWS_WITH(plan(o), Contains("path.sweep_of: \"current\" needs a processor") &&
                                 Contains("63.3 us"));
  o.processor = {8, 100};
  o.point_clk = 0;
  CHECK_NOTHROW(plan(o));
  o.path.sweep_amplitude_A = 5;
  CHECK_THROWS_WITH(plan(o), Contains("path.sweep_amplitude_A: value 5 ") &&
                                 Contains("(at plant.x.current_full_scale_A = 9.6)"));
  o.path.sweep_amplitude_A = 1;
  o.processor.access_clk = 300;
  CHECK_THROWS_WITH(plan(o), Contains("path.sweep_of: \"current\" needs a processor") &&
                                 Contains("93.2 us"));

  o = with(PathKind::kSquare);
  o.path.square_high_m = o.path.square_low_m;
  CHECK_THROWS_WITH(plan(o), Contains("path.square_high_m: must differ"));

  o = {};
  o.chip.following_error_m = 12e-6;  // 2.4 counts: 3 keep a table of 2.4 from a trip
  CHECK(plan(o).following_limit == 3);
  o.chip.axis[0].stroke_max_m = 0.35;  // the circle touches it
  CHECK_NOTHROW(plan(o));

  o = {};
  o.chip.watchdog_ticks = 4;
  CHECK_THROWS_WITH(plan(o), Contains("chip.watchdog_ticks: value 4") && Contains("5.."));
  o.chip.watchdog_ticks = 0;
  CHECK_NOTHROW(plan(o));
}
