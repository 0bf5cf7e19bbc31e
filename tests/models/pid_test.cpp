// SPDX-License-Identifier: Apache-2.0
//
// The PID on a mass against closed forms. It holds its force for a period of 10 us, some 1e-3 of
// the time constants here: that is the margin of the comparisons.

#include "models/ideal/pid.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/mass.hpp"

using trammel::ideal::Pid;
using trammel::test::Mass;

namespace {

constexpr double kPeriod = 1e-5;  // [s]
constexpr double kMass = 2.5;
constexpr double kPole = 60;

}  // namespace

TEST_CASE("a load that begins moves the mass as three equal poles do") {
  // x/F = (1/M) s/(s + w)^3: a step of F gives F/(2 M) t^2 exp(-w t)
  const Pid::Config c = Pid::for_mass(kMass, kPole, 1e9, kPeriod);
  Pid::State s;
  Mass mass{kMass};
  const double largest = 10 / (2 * kMass) * std::pow(2 / kPole, 2) * std::exp(-2.0);
  for (int n = 1; n <= 30000; ++n) {
    mass.push(Pid::step(c, s, 0, mass.x) - 10, kPeriod);
    const double t = n * kPeriod;
    const double x = -10 / (2 * kMass) * t * t * std::exp(-kPole * t);
    CHECK(mass.x == Approx(x).margin(2e-3 * largest));
  }
  CHECK(s.z == Approx(10).epsilon(1e-3));
}

TEST_CASE("on a ramp it does not lag in the end") {
  const Pid::Config c = Pid::for_mass(kMass, kPole, 1e9, kPeriod);
  Pid::State s;
  Mass mass{kMass};
  double x_ref = 0;
  for (int n = 0; n < 200000; ++n) {
    mass.push(Pid::step(c, s, x_ref += 0.5 * kPeriod, mass.x), kPeriod);
  }
  CHECK(x_ref - mass.x == Approx(0).margin(2 * 0.5 * kPeriod));
}

TEST_CASE("without integral part a constant load moves it by load over K_p") {
  Pid::Config c = Pid::for_mass(kMass, kPole, 1e9, kPeriod);
  c.ki = 0;
  Pid::State s;
  Mass mass{kMass};
  for (int n = 0; n < 200000; ++n) mass.push(Pid::step(c, s, 0, mass.x) - 10, kPeriod);
  CHECK(mass.x == Approx(-10 / c.kp).epsilon(1e-6));
}

TEST_CASE("a PID at its limit does not wind up") {
  const Pid::Config c = Pid::for_mass(kMass, kPole, 50, kPeriod);
  Pid::State s;
  for (int n = 0; n < 100000; ++n) CHECK(Pid::step(c, s, 10, 0) == 50);  // held, 10 m short
  CHECK(s.z == Approx(50));  // no more than holds that force
  s.e = -1;                  // no kick of the derivative
  CHECK(Pid::step(c, s, -1, 0) == -50);
}
