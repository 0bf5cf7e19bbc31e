// SPDX-License-Identifier: Apache-2.0
//
// Each force on a carriage by its own sign: free, against the stop at either end, and against
// motion in either sense; and the lines of the table that tell of it.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "models/plant/xy_table.hpp"

using namespace trammel::plant;
namespace xy = trammel::xy;

namespace {

constexpr double kPeriod = 20e-9;  // [s]
constexpr double kLow = 0.013, kHigh = 0.327;

AxisConfig bare() {
  AxisConfig c;
  c.coulomb_n = c.viscous_n_s_m = c.cogging_n = c.external_force_n = c.stribeck_n = 0;
  c.cogging_harmonic_n = c.cable_n_m = c.load_n = 0;
  c.brake = false;
  c.hard_stops = true;
  c.stroke_min_m = kLow;
  c.stroke_max_m = kHigh;
  c.mass_kg = 4;
  c.payload_kg = 1;
  return c;
}

struct Force {
  std::string name;
  AxisConfig config;
  double newton;  // on a carriage at x, positive along x
};

// Each term alone, at place x and of the sign asked, by its definition.
std::vector<Force> forces_at(double x, double sign) {
  std::vector<Force> all;
  const auto add = [&](const char* name, double newton, auto set) {
    AxisConfig c = bare();
    set(c);
    all.push_back({name, c, newton});
  };
  const AxisConfig c = bare();
  const double k = std::acos(-1.0) / c.pole_pitch_m;
  add("external force", -sign * 10, [&](AxisConfig& a) { a.external_force_n = sign * 10; });
  add("load", -sign * 10, [&](AxisConfig& a) { a.load_n = sign * 10; });
  add("cogging", -sign * 20 * std::sin(2 * k * x), [&](AxisConfig& a) { a.cogging_n = sign * 20; });
  add("harmonic of the cogging", -sign * 20 * std::sin(2 * c.cogging_harmonic * k * x + 1),
      [&](AxisConfig& a) { a.cogging_harmonic_n = sign * 20; });
  add("cable", 50 * sign * 0.2, [&](AxisConfig& a) {
    a.cable_n_m = 50;
    a.cable_rest_m = x + sign * 0.2;
  });
  return all;
}

AxisState after(AxisConfig c, double x, double seconds) {
  c.start_m = x;
  Axis axis(c, kPeriod);
  const auto end = static_cast<Clk>(seconds / kPeriod);
  while (axis.next() <= end) axis.commit(axis.next(), 0);
  return axis.state(end);
}

}  // namespace

TEST_CASE("each force accelerates a free carriage by its sign, its mass with what it carries") {
  for (const double x : {0.105, 0.216}) {
    for (const double sign : {1.0, -1.0}) {
      for (const Force& force : forces_at(x, sign)) {
        const double seconds = 2e-3;
        const AxisState s = after(force.config, x, seconds);
        INFO(force.name << " " << force.newton << " N at " << x << " m: speed " << s.v_m_s);
        CHECK(s.v_m_s == Approx(force.newton / 5 * seconds).epsilon(0.01));
        CHECK(s.x_m - x == Approx(force.newton / 10 * seconds * seconds).epsilon(0.01));
      }
    }
  }
}

TEST_CASE("a carriage at a stop is held by each force toward it, and leaves by each away from it") {
  for (const bool high : {false, true}) {
    const double x = high ? kHigh : kLow;
    for (const double sign : {1.0, -1.0}) {
      for (const Force& force : forces_at(x, sign)) {
        const AxisState s = after(force.config, x, 5e-3);
        INFO(force.name << " " << force.newton << " N at the " << (high ? "upper" : "lower")
                        << " stop: at " << s.x_m << " m, speed " << s.v_m_s);
        REQUIRE(std::abs(force.newton) > 1);
        if ((force.newton > 0) == high) {
          CHECK(s.x_m == x);
          CHECK(s.v_m_s == 0);
        } else {
          CHECK(s.v_m_s * force.newton > 0);
          CHECK((high ? x - s.x_m : s.x_m - x) > 1e-6);
        }
      }
    }
  }
}

TEST_CASE("each friction is against the motion, in either sense") {
  for (const double sign : {1.0, -1.0}) {
    const auto friction = [&](const char* name, double newton, auto set) {
      AxisConfig c = bare();
      c.external_force_n = -sign * 30;
      set(c);
      const double seconds = 0.05;
      const AxisState s = after(c, 0.17, seconds);
      INFO(name << ", pushed by " << sign * 30 << " N: speed " << s.v_m_s);
      CHECK(s.v_m_s == Approx(sign * (30 - newton) / 5 * seconds).epsilon(0.02));
    };
    friction("none", 0, [](AxisConfig&) {});
    friction("Coulomb", 8, [](AxisConfig& c) { c.coulomb_n = 8; });
    // v = F/B (1 - exp(-B t/M)) is F/M t less about a quarter with B = 60.
    AxisConfig c = bare();
    c.external_force_n = -sign * 30;
    c.viscous_n_s_m = 60;
    CHECK(after(c, 0.17, 0.05).v_m_s == Approx(sign * 0.5 * (1 - std::exp(-0.6))).epsilon(1e-3));
  }
}

TEST_CASE("the lines of one axis tell of it alone: A leads up, B down, the index at its place") {
  for (int moved = 0; moved < 2; ++moved) {
    for (const double sign : {1.0, -1.0}) {
      XyTableConfig config;
      config.axis = {bare(), bare()};
      for (AxisConfig& axis : config.axis) {
        axis.start_m = 0.1;
        axis.index_m = 0.1 + sign * 0.0005;
      }
      config.axis[static_cast<std::size_t>(moved)].external_force_n = -sign * 100;
      XyTable table(config);
      CAPTURE(moved, sign);
      Lines before = table.sense();
      const int a = xy::encoder_a(moved), b = xy::encoder_b(moved), z = xy::encoder_z(moved);
      int up = 0, index = 0;
      for (Clk n = table.next(); n < 1'500'000; n = table.next()) {
        table.commit(n, 0);
        const Lines now = table.sense(), changed = now ^ before;
        REQUIRE((changed & ~(Lines{1} << a | Lines{1} << b | Lines{1} << z)) == 0);
        const bool was_b = (before >> b & 1) != 0, is_a = (now >> a & 1) != 0;
        // Up: A rises while B is low.
        if ((changed >> a & 1) != 0 && is_a) up += was_b ? -1 : 1;
        if ((changed >> z & 1) != 0 && (now >> z & 1) != 0) ++index;
        before = now;
      }
      CHECK(index == 1);
      CHECK(up * sign > 50);
      CHECK(table.count(1 - moved) == 20000);
    }
  }
}

TEST_CASE("each value of an axis reaches its motor") {
  AxisConfig c;
  double value = 1.5;
  const auto next = [&value] { return value += 0.25; };
  const struct {
    const char* name;
    double AxisConfig::* of_axis;
    double PmlsmConfig::* of_motor;
  } values[] = {
      {"resistance", &AxisConfig::resistance_ohm, &PmlsmConfig::resistance},
      {"inductance d", &AxisConfig::inductance_d_h, &PmlsmConfig::inductance_d},
      {"inductance q", &AxisConfig::inductance_q_h, &PmlsmConfig::inductance_q},
      {"force constant", &AxisConfig::force_constant_n_a, &PmlsmConfig::force_constant},
      {"pole pitch", &AxisConfig::pole_pitch_m, &PmlsmConfig::pole_pitch},
      {"Coulomb", &AxisConfig::coulomb_n, &PmlsmConfig::coulomb},
      {"viscous", &AxisConfig::viscous_n_s_m, &PmlsmConfig::viscous},
      {"cogging", &AxisConfig::cogging_n, &PmlsmConfig::cogging},
      {"friction speed", &AxisConfig::friction_speed_m_s, &PmlsmConfig::friction_speed},
      {"external force", &AxisConfig::external_force_n, &PmlsmConfig::external_force},
      {"Stribeck", &AxisConfig::stribeck_n, &PmlsmConfig::stribeck},
      {"Stribeck speed", &AxisConfig::stribeck_speed_m_s, &PmlsmConfig::stribeck_speed},
      {"harmonic", &AxisConfig::cogging_harmonic_n, &PmlsmConfig::harmonic_force},
      {"cable", &AxisConfig::cable_n_m, &PmlsmConfig::cable},
      {"cable's rest", &AxisConfig::cable_rest_m, &PmlsmConfig::cable_rest}};
  for (const auto& one : values) c.*one.of_axis = next();
  c.payload_kg = 7;
  c.cogging_harmonic = 6;
  const PmlsmConfig m = motor_config(c);
  for (const auto& one : values) {
    INFO(one.name);
    CHECK(m.*one.of_motor == c.*one.of_axis);
  }
  CHECK(m.mass == c.mass_kg + 7);
  CHECK(m.harmonic == 6);
}
