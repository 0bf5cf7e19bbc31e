// SPDX-License-Identifier: Apache-2.0
//
// Faults of the axis against closed forms: a phase that is open, a supply that dips. The carriage
// is held, so that two legs in series are a circuit of 2 R and 2 L.
#include <catch2/catch.hpp>

#include <cmath>

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
