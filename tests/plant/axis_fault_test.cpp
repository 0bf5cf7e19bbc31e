// SPDX-License-Identifier: Apache-2.0
//
// Faults and loads of the axis against closed forms, and spans of any length: a phase that is open,
// a supply that dips, a force that comes and goes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>

#include "models/plant/axis.hpp"

using namespace trammel::plant;

namespace {

constexpr double kPeriod = 20e-9;  // [s]
constexpr unsigned kAOverB = 1u | 2u << 3;  // upper switch of a, lower one of b; c floats
constexpr unsigned kAOverBAndC = 1u | 2u << 3 | 4u << 3;

AxisConfig held() {
  AxisConfig c;
  c.start_m = 0.307;  // an angle of no symmetry
  c.locked = true;
  return c;
}

double volt(const AxisConfig& c) { return c.dc_link_v; }
double time_constant(const AxisConfig& c) { return c.inductance_q_h / c.resistance_ohm; }

// Of two legs in series on the link, `t` after it was `first` [A].
double series(const AxisConfig& c, double t, double first, double share = 1) {
  const double last = share * volt(c) / (2 * c.resistance_ohm);
  return last + (first - last) * std::exp(-t / time_constant(c));
}

AxisConfig frictionless() {
  AxisConfig c;
  c.start_m = 0.3;
  c.coulomb_n = c.viscous_n_s_m = 0;
  c.brake = false;
  c.mass_kg = 2;
  return c;
}

// The state at time t of an axis that commits only its own events, gates off.
AxisState state_at(const AxisConfig& config, double t) {
  Axis axis(config, kPeriod);
  const auto end = static_cast<Clk>(t / kPeriod);
  while (axis.next() <= end) axis.commit(axis.next(), 0);
  return axis.state(end);
}

// Two equal axes but for their spans, under the same gates: each leg changes over by itself, with a
// dead time, and rests for up to 60 us.
struct Pair {
  Axis coarse, fine;
  std::mt19937 random{7};
  unsigned gates = 070;
  Clk now = 0;

  static AxisConfig with(AxisConfig c, double span) {
    c.longest_span_s = span;
    return c;
  }
  explicit Pair(const AxisConfig& c)
      : coarse(c, kPeriod), fine(with(c, 0.5e-6), kPeriod) {}

  static void move(Axis& axis, Clk end, unsigned set) {
    while (axis.next() < end) axis.commit(axis.next(), axis.gates());
    axis.commit(end, set);
  }
  void set(Clk after, unsigned to) {
    now += after;
    gates = to;
    move(coarse, now, gates);
    move(fine, now, gates);
  }
  void turn_over() {
    const auto leg = static_cast<unsigned>(random() % 3);
    const unsigned upper = 1u << leg, lower = 8u << leg;
    const bool up = (gates & lower) != 0;
    set(static_cast<Clk>(1 + random() % 3000), gates & ~(upper | lower));
    set(static_cast<Clk>(1 + random() % 120), gates | (up ? upper : lower));
  }
};

struct Motor {
  std::string name;
  AxisConfig config;
  double within = 1e-6;  // of the largest value, or 10 mm
};

AxisConfig changed(void (*change)(AxisConfig&)) {
  AxisConfig c;
  c.start_m = 0.3;
  c.hard_stops = false;
  change(c);
  return c;
}

}  // namespace

TEST_CASE("with an open phase the others are a circuit of two windings in series") {
  const AxisConfig c = held();
  Axis axis(c, kPeriod);
  axis.open_phase(0, 2, true);
  axis.commit(0, kAOverBAndC);
  for (Clk n = 500; n <= 100'000; n += 500) {
    while (axis.next() <= n) axis.commit(axis.next(), kAOverBAndC);
    const AxisState s = axis.state(n);
    CAPTURE(n);
    REQUIRE(s.i_a_a + s.i_b_a == Approx(0).margin(1e-12));
    REQUIRE(s.i_a_a == Approx(series(c, static_cast<double>(n) * kPeriod, 0)).epsilon(1e-6));
    // Current along b - a in the stationary frame; theta is 0 along a.
    const double theta = M_PI * s.x_m / c.pole_pitch_m;
    const double alpha = s.i_a_a, beta = (s.i_a_a + 2 * s.i_b_a) / std::sqrt(3.0);
    const double i_q = -std::sin(theta) * alpha + std::cos(theta) * beta;
    REQUIRE(s.i_q_a == Approx(i_q).epsilon(1e-9));
  }
}

TEST_CASE("a phase that opens under current loses it at once and takes it up when it closes") {
  const AxisConfig c = held();
  Axis axis(c, kPeriod);
  axis.commit(0, kAOverBAndC);
  const auto run = [&](Clk end) {
    while (axis.next() < end) axis.commit(axis.next(), kAOverBAndC);
    axis.commit(end, kAOverBAndC);  // a fault begins after a commit
  };
  run(20'000);
  const AxisState before = axis.state(20'000);
  REQUIRE(before.i_a_a > 1);
  REQUIRE(-before.i_a_a - before.i_b_a < -0.5);
  axis.open_phase(20'000, 2, true);
  const AxisState opened = axis.state(20'000);
  CHECK(-opened.i_a_a - opened.i_b_a == Approx(0).margin(1e-12));
  run(60'000);
  const AxisState later = axis.state(60'000);
  CHECK(later.i_a_a == Approx(series(c, 40'000 * kPeriod, opened.i_a_a)).epsilon(1e-6));
  axis.open_phase(60'000, 2, false);
  run(2'000'000);  // 39 ms, 45 time constants
  // One winding over two in parallel.
  const double whole = volt(c) / (1.5 * c.resistance_ohm);
  CHECK(axis.state(2'000'000).i_a_a == Approx(whole).epsilon(1e-6));
  CHECK(axis.state(2'000'000).i_b_a == Approx(-whole / 2).epsilon(1e-6));
}

TEST_CASE("a supply that dips drives that share of the current, and the whole again afterwards") {
  const AxisConfig c = held();
  Axis axis(c, kPeriod);
  axis.open_phase(0, 2, true);
  axis.commit(0, kAOverB);
  const auto run = [&](Clk end) {
    while (axis.next() < end) axis.commit(axis.next(), kAOverB);
    axis.commit(end, kAOverB);
  };
  run(50'000);
  axis.supply(50'000, 0.4);
  const double first = axis.state(50'000).i_a_a;
  CHECK(first == Approx(series(c, 50'000 * kPeriod, 0)).epsilon(1e-6));
  run(80'000);
  CHECK(axis.state(80'000).i_a_a ==
        Approx(series(c, 30'000 * kPeriod, first, 0.4)).epsilon(1e-6));
  axis.supply(80'000, 1);
  const double second = axis.state(80'000).i_a_a;
  run(130'000);
  CHECK(axis.state(130'000).i_a_a == Approx(series(c, 50'000 * kPeriod, second)).epsilon(1e-6));
}

TEST_CASE("a step of force accelerates from its time on, against positive motion") {
  AxisConfig c = frictionless();
  c.load_n = 10;
  c.load_begin_s = 0.0123457;
  CHECK(state_at(c, 0.0123).x_m == 0.3);
  const double t = 0.05 - c.load_begin_s;
  const AxisState s = state_at(c, 0.05);
  CHECK(s.v_m_s == Approx(-5 * t).epsilon(1e-5));
  CHECK(s.x_m - 0.3 == Approx(-2.5 * t * t).epsilon(1e-5));
}

TEST_CASE("a pulse ends at its end, and adds to the constant force") {
  AxisConfig c = frictionless();
  c.external_force_n = -4;
  c.load_n = 10;
  c.load_begin_s = 0.01;
  c.load_end_s = 0.02;
  CHECK(state_at(c, 0.01).v_m_s == Approx(0.02).epsilon(1e-5));
  CHECK(state_at(c, 0.02).v_m_s == Approx(0.02 - 0.03).epsilon(1e-5));
  CHECK(state_at(c, 0.03).v_m_s == Approx(0.02 - 0.03 + 0.02).epsilon(1e-4));
}

TEST_CASE("a load from the start on is there from the start on") {
  AxisConfig c = frictionless();
  c.load_n = -10;
  CHECK(state_at(c, 0.02).v_m_s == Approx(0.1).epsilon(1e-4));
}

TEST_CASE("spans as long as a motor allows agree with spans of 0.5 us") {
  const Motor motors[]{
      {"default", changed([](AxisConfig&) {})},
      {"slow currents", changed([](AxisConfig& c) { c.resistance_ohm = 2; })},
      {"salient", changed([](AxisConfig& c) { c.inductance_q_h = 40e-3; })},
      {"cogging and harmonic", changed([](AxisConfig& c) {
         c.cogging_n = 20;
         c.cogging_harmonic_n = 5;
         c.cogging_harmonic = 12;
       })},
      {"stribeck", changed([](AxisConfig& c) { c.stribeck_n = 4; })},
      {"light and quick", changed([](AxisConfig& c) {
         c.mass_kg = 0.2;
         c.pole_pitch_m = 2e-3;
       }), 2e-3},  // friction turns over in 17 us
      {"poles that pass fast", changed([](AxisConfig& c) {  // 5000 turns a second
         c.pole_pitch_m = 1e-4;
         c.external_force_n = -100;
         c.viscous_n_s_m = 100;
       }), 5e-5},
      {"elastic", changed([](AxisConfig& c) { c.mode_hz = 120; })},
      {"stiff and elastic", changed([](AxisConfig& c) { c.mode_hz = 800; })},
      {"a soft link", changed([](AxisConfig& c) { c.supply_ohm = 2; })},
      {"drops", changed([](AxisConfig& c) {
         c.switch_drop_v = 1.5;
         c.diode_drop_v = 0.8;
       }), 4e-4},  // the drops change sign where a span begins
  };
  for (const Motor& motor : motors) {
    Pair pair(motor.config);
    double current = 0, speed = 0, worst_current = 0, worst_speed = 0, worst_x = 0;
    for (int k = 0; k < 3000; ++k) {
      pair.turn_over();
      const AxisState a = pair.coarse.state(pair.now), b = pair.fine.state(pair.now);
      current = std::max({current, std::fabs(b.i_d_a), std::fabs(b.i_q_a)});
      speed = std::max(speed, std::fabs(b.v_m_s));
      worst_current = std::max(
          {worst_current, std::fabs(a.i_d_a - b.i_d_a), std::fabs(a.i_q_a - b.i_q_a)});
      worst_speed = std::max(worst_speed, std::fabs(a.v_m_s - b.v_m_s));
      worst_x = std::max(worst_x, std::fabs(a.x_m - b.x_m));
    }
    INFO(motor.name << ": currents to " << current << " A, off by " << worst_current
                    << " A; speed to " << speed << " m/s, off by " << worst_speed << " m/s; by "
                    << worst_x << " m");
    CHECK(current > 0.5);
    CHECK(worst_current < motor.within * current);
    CHECK(worst_speed < motor.within * speed);
    CHECK(worst_x < motor.within * 0.01);
  }
}
