// SPDX-License-Identifier: Apache-2.0
//
// The words of the program: of the specification by default, and at each rate of the chip, of axes
// that have nothing in common, against the same computed in seconds, metres and amperes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "lab/layers.hpp"
#include "machines/kung/plan/parts.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "models/fixed/fixed.hpp"
#include "tests/support/points.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

using namespace trammel;
using namespace trammel::kung;
using Catch::Contains;

sw::KungSetup plan(const Options& options) {
  static std::shared_ptr<const Plan> made;
  made = make_plan(options);
  return made->setup;
}

Options with(PathKind kind) {
  Options o;
  o.path.kind = kind;
  return o;
}

bool equal(sw::Gain a, sw::Gain b) { return a.mant == b.mant && a.exp == b.exp; }

double value_of(const sw::Gain& g) { return std::ldexp(g.mant / 2048.0, g.exp); }

// A mantissa has 11 bits, of which the highest may be 0.
Approx word_of(double value) { return Approx(value).epsilon(1.0 / 1024); }

Options unlike(int position_Hz, int carrier_Hz) {
  Options o;
  o.chip.position_Hz = position_Hz;
  o.chip.carrier_Hz = carrier_Hz;
  o.chip.dead_time_min_ns = 210;  // 10.5 clk
  o.chip.current_limit_A = 4;
  o.chip.d_current_A = 0.5;
  o.chip.following_error_m = 0.0042;
  o.chip.offset_samples = 9;
  o.chip.watchdog_ticks = 77;
  o.settle_s = 0;
  for (std::size_t a = 0; a < 2; ++a) {
    const double d = 1 + 0.25 * static_cast<double>(a);
    const int n = static_cast<int>(a);
    AxisGains& g = o.gains[a];
    g.kp = 0.41 * d;
    g.ki = 0.0035 * d;
    g.kv = 1.7 * d;
    g.learning_rate = 0.12 * d;
    g.shift_e = 1 - 2 * n;
    g.shift_de = 3 - 4 * n;
    g.current_kp_V_A = 80 * d;
    g.current_ki_V_A = 5 * d;
    g.theta_offset_rad = a == 0 ? 1 : -2;
    AxisChip& c = o.chip.axis[a];
    c.dead_time_ns = 1010 + 1000 * n;  // 50.5 and 100.5 clk
    c.qep_filter_clk = 4 + n;
    c.stroke_min_m = -0.01 * d;
    c.stroke_max_m = 0.6 - 0.02 * n;
    c.stroke_check = a == 1;
    o.plant.axis[a].dc_link_v = 300 - 50 * n;
    o.plant.axis[a].pole_pitch_m = 0.0305 - 0.005 * n;
    o.plant.axis[a].current_full_scale_a = 12;
    o.plant.axis[a].adc_bits = 12 + 2 * n;
  }
  return o;
}

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

TEST_CASE("a run has the plan that validation made, until a key is changed") {
  Options o;
  lab::validate(o);
  const auto made = plan_of(o);
  CHECK(made == o.prepared);
  const auto same = o.clone();
  CHECK(plan_of(static_cast<const Options&>(*same)) == made);
  o.path.circle_radius_m = 0.05;
  CHECK(made->walk.high.x - plan_of(o)->walk.high.x == Approx(10'000).margin(2));
}

TEST_CASE("points become counts and stay with their owner") {
  Options o = with(PathKind::kPoints);
  PathFile file;
  file.points = {{0.1, 0.2}, {0.100005, 0.2}};
  const auto made = make_plan(o, file);
  const std::vector<sw::Point>& points = made->store.points;
  REQUIRE(points.size() == 2);
  CHECK(made->setup.points == points.data());
  CHECK(points[1] == sw::Point{20001, 40000});
  o.path.repeats = 2;
  CHECK_THROWS_WITH(make_plan(o, file), Contains("path.repeats") && Contains("1..1"));
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

TEST_CASE("the words of each axis at each rate are those of its own values in physical units") {
  constexpr double kTurn = 6.283185307179586;
  const int positions[] = {1000, 2000, 4000}, carriers[] = {16000, 8000, 20000, 40000};
  for (std::uint32_t p = 0; p < 3; ++p) {
    for (std::uint32_t c = 0; c < 4; ++c) {
      const Options o = unlike(positions[p], carriers[c]);
      const sw::KungSetup s = plan(o);
      CAPTURE(positions[p], carriers[c]);
      CHECK(s.position_rate == p);
      CHECK(s.carrier == c);
      CHECK(s.current_limit == 683);    // 4 A of 12 A / 2048
      CHECK(s.d_current_limit == 85);   // 0.5 A
      CHECK(s.following_limit == 840);  // of 5 um
      CHECK(s.dead_time_min == 11);
      CHECK(s.offset_samples == 9);
      CHECK(s.watchdog_ticks == 77);
      CHECK(s.irq_period == 4);
      const double slower = 2000.0 / positions[p];  // a sample in those of 0.5 ms
      for (std::size_t a = 0; a < 2; ++a) {
        CAPTURE(a);
        const double d = 1 + 0.25 * static_cast<double>(a);
        const auto n = static_cast<std::uint32_t>(a);
        const sw::AxisSetup& x = s.axis[a];
        // Errors are the same words at each rate, speeds in counts a sample grow with its length.
        CHECK(value_of(x.kp) == word_of(0.41 * d * slower));
        CHECK(value_of(x.ki) == word_of(0.0035 * d * slower * slower));
        CHECK(value_of(x.kv) == word_of(1.7 * d / slower * 9.6 / 12));
        CHECK(value_of(x.eta) ==
              word_of(0.12 * d * (0.41 * d + 0.0035 * d) * 1.7 * d / 32 * slower));
        // Volts of V_dc / sqrt 3 / 2048 per ampere of I_fs / 4096.
        const double volts = 6 * std::sqrt(3.0) / (a == 0 ? 300 : 250);
        CHECK(value_of(x.kp_cur) == word_of(80 * d * volts));
        CHECK(value_of(x.ki_cur) == word_of(5 * d * volts * 16000 / carriers[c]));
        CHECK(x.shift_e == (a == 0 ? 1 : -1));
        CHECK(x.shift_de == (a == 0 ? 3 : -1) + (p == 2) - (p == 0));
        const double step = std::ldexp(5e-6 / (2 * (a == 0 ? 0.0305 : 0.0255)), 32);
        CHECK(std::fabs(x.angle_step - step) <= 1);
        const double turned = a == 0 ? 1 / kTurn : 1 - 2 / kTurn;
        CHECK(std::fabs(x.theta_ofs - std::ldexp(turned, 32)) <= 1);
        CHECK(x.dead_time == (a == 0 ? 51 : 101));
        CHECK(x.qep_filter == 4 + n);
        CHECK(x.adc_zeros == (a == 0 ? 4 : 2));
        CHECK(x.stroke_min == (a == 0 ? -2000 : -2500));
        CHECK(x.stroke_max == (a == 0 ? 120'000 : 116'000));
        CHECK(x.stroke_check == (a == 1));
        CHECK(x.adapt);
        CHECK_FALSE(x.interpolate);
        CHECK_FALSE(x.feedforward);
      }
    }
  }
}

TEST_CASE("each axis is held against its own limits, at both ends of its path") {
  for (const std::size_t a : {std::size_t{0}, std::size_t{1}}) {
    for (const bool high : {false, true}) {
      for (const bool plant : {false, true}) {
        for (const bool beyond : {false, true}) {
          CAPTURE(a, high, plant, beyond);
          Options o;  // x 0.15..0.35, y 0.17..0.37
          o.path.circle_center_y_m = 0.27;
          const double low_end = a == 0 ? 0.15 : 0.17, high_end = a == 0 ? 0.35 : 0.37;
          const double off = beyond ? 1e-4 : 0;
          double& limit = plant ? (high ? o.plant.axis[a].stroke_max_m
                                        : o.plant.axis[a].stroke_min_m)
                                : (high ? o.chip.axis[a].stroke_max_m
                                        : o.chip.axis[a].stroke_min_m);
          limit = high ? high_end - off : low_end + off;
          std::string message;
          try {
            plan(o);
          } catch (const std::exception& error) {
            message = error.what();
          }
          const std::string what = (plant ? "the hard stops plant." : "chip.") +
                                   std::string(a == 0 ? "x" : "y") + ".stroke_min_m";
          CHECK((message.find(what) != std::string::npos) == beyond);
          CHECK(message.empty() == !beyond);
        }
      }
    }
  }
}
