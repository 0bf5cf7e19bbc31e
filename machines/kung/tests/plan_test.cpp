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
  Options o;
  o.chip.following_error_m = 12e-6;  // 2.4 counts: 3 keep a table of 2.4 from a trip
  CHECK(plan(o).following_limit == 3);
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
