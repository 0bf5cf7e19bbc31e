// SPDX-License-Identifier: Apache-2.0
//
// The cascade of P and PI on a mass against closed forms. It holds its force for a period of 10 us,
// some 1e-3 of the slowest time constant here: that is the margin of the comparisons.

#include "models/ideal/cascade.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/mass.hpp"

using trammel::ideal::Cascade;
using trammel::test::Mass;

namespace {

constexpr double kPeriod = 1e-5;  // [s]

// One period; returns the force of the controller.
double advance(const Cascade::Config& c, Cascade::State& s, Mass& mass, double x_ref, double v_ff,
               double load = 0) {
  const double force = Cascade::step(c, s, {x_ref, v_ff, mass.x, mass.v});
  mass.push(force - load, kPeriod);
  return force;
}

}  // namespace

TEST_CASE("without its integral part a step of 1 m is that of two equal poles") {
  // s^2 + (K_v/M) s + K_v K_p/M = (s + 2 K_p)^2 with K_v = 4 M K_p
  const Cascade::Config c{25, 4 * 2.5 * 25, 0, 1e9, kPeriod};
  Cascade::State s;
  Mass mass{2.5};
  for (int n = 1; n <= 20000; ++n) {
    advance(c, s, mass, 1, 0);
    const double at = 50 * n * kPeriod;
    CHECK(mass.x == Approx(1 - (1 + at) * std::exp(-at)).margin(2e-3));
  }
}

TEST_CASE("on a ramp it lags by speed over K_p, and with feed-forward not at all") {
  const Cascade::Config c = Cascade::for_mass(2.5, 100, 1e9, kPeriod);
  for (const double share : {0.0, 1.0}) {
    Cascade::State s;
    Mass mass{2.5};
    double x_ref = 0;
    for (int n = 0; n < 200000; ++n) advance(c, s, mass, x_ref += 0.5 * kPeriod, 0.5 * share);
    CHECK(x_ref - mass.x == Approx((1 - share) * 0.5 / 25).margin(2 * 0.5 * kPeriod));
  }
}

TEST_CASE("a constant load moves it by load over K_v K_p, and with an integral part not at all") {
  Cascade::Config c = Cascade::for_mass(2.5, 100, 1e9, kPeriod);
  for (const bool integral : {false, true}) {
    if (!integral) c.ki = 0;
    Cascade::State s;
    Mass mass{2.5};
    for (int n = 0; n < 200000; ++n) advance(c, s, mass, 0, 0, 10);
    CHECK(-mass.x == Approx(integral ? 0 : 10 / (c.kv * c.kp)).margin(1e-9));
    c = Cascade::for_mass(2.5, 100, 1e9, kPeriod);
    if (integral) CHECK(s.z == Approx(10).epsilon(1e-6));
  }
}

TEST_CASE("its speed loop alone answers a speed step as a double pole with a zero does") {
  // v/v* = (2 w s + w^2)/(s + w)^2: 1 - (1 - w t) exp(-w t), by feed-forward with K_p = 0
  Cascade::Config c = Cascade::for_mass(2.5, 100, 1e9, kPeriod);
  c.kp = 0;
  Cascade::State s;
  Mass mass{2.5};
  for (int n = 1; n <= 10000; ++n) {
    advance(c, s, mass, 0, 1);
    const double wt = 100 * n * kPeriod;
    CHECK(mass.v == Approx(1 - (1 - wt) * std::exp(-wt)).margin(2e-3));
  }
}

TEST_CASE("a force at its limit does not wind the integral part up") {
  const Cascade::Config c = Cascade::for_mass(2.5, 100, 50, kPeriod);
  Cascade::State s;
  for (int n = 0; n < 100000; ++n) {
    CHECK(Cascade::step(c, s, {10, 0, 0, 0}) == 50);  // it is held, 10 m short
  }
  CHECK(s.z == Approx(50));  // no more than holds that force
  CHECK(Cascade::step(c, s, {-1, 0, 0, 0}) == -50);
}
