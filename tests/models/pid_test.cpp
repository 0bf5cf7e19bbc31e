// SPDX-License-Identifier: Apache-2.0
//
// Controllers on a mass against closed forms: each holds its force for a period of 10 us, some
// 1e-3 of the time constants here, which is the margin of the comparisons. And the LM628's filter
// by hand.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "models/exact/control/lm628_pid.hpp"
#include "models/ideal/cascade.hpp"
#include "models/ideal/pid.hpp"
#include "tests/support/mass.hpp"

using trammel::ideal::Pid;
using trammel::test::Mass;
using trammel::ideal::Cascade;
using trammel::exact::Lm628Pid;

namespace {

constexpr double kPeriod = 1e-5;  // [s]
constexpr double kMass = 2.5;
constexpr double kPole = 60;

// One period; returns the force of the controller.
double advance(const Cascade::Config& c, Cascade::State& s, Mass& mass, double x_ref, double v_ff,
               double load = 0) {
  const double force = Cascade::step(c, s, {x_ref, v_ff, mass.x, mass.v});
  mass.push(force - load, kPeriod);
  return force;
}

Lm628Pid::Config gains(std::int64_t kp, std::int64_t ki, std::int64_t kd, std::int64_t il) {
  Lm628Pid::Config c;
  c.kp = kp;
  c.ki = ki;
  c.kd = kd;
  c.il = il;
  return c;
}

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

TEST_CASE("lm628_pid saturates each product and the sum at 32 767, or wraps them at 16 bits") {
  Lm628Pid::Config c = gains(300, 0, 0, 0);
  CHECK(Lm628Pid().step(c, 110) == 32767);  // 33 000
  CHECK(Lm628Pid().step(c, -110) == -32767);
  c.wrap = true;
  CHECK(Lm628Pid().step(c, 110) == 33000 - 65536);
  CHECK(Lm628Pid().step(c, -110) == 65536 - 33000);
  CHECK(Lm628Pid().step(c, 300) == 90000 - 65536);

  c = gains(200, 0, 200, 0);  // 20 000 and 20 000
  CHECK(Lm628Pid().step(c, 100) == 32767);
  c.wrap = true;
  CHECK(Lm628Pid().step(c, 100) == 40000 - 65536);
}

TEST_CASE("lm628_pid saturates its products before it adds them") {
  Lm628Pid pid;
  Lm628Pid::Config c = gains(300, 0, 32767, 0);
  pid.step(c, 200);                        // 60 000 and 6 553 400: 65 534, so 32 767
  CHECK(pid.step(c, 199) == 32767 - 32767);  // 59 700 and -32 767: not 26 933
  c.wrap = true;
  CHECK(pid.step(c, 199) == 59700 - 65536);
}

TEST_CASE("lm628_pid limits the integral by its full product, and the sum to 24 bits") {
  Lm628Pid pid;
  const Lm628Pid::Config c = gains(0, 3, 0, 20000);
  CHECK(pid.step(c, 32767) == 3 * 127);  // 32 767 / 256, rounded down
  for (int n = 0; n < 1000; ++n) pid.step(c, 32767);
  CHECK(pid.sum() == 32767);             // (2^23 - 1) / 256
  CHECK(pid.step(c, 0) == 20000);        // of 98 301
  CHECK(pid.step(c, -32767) == 20000);
  for (int n = 0; n < 1000; ++n) pid.step(c, -32767);
  CHECK(pid.sum() == -32768);            // -(2^23 - 1) / 256, rounded down
  CHECK(pid.step(c, 0) == -20000);

  Lm628Pid wrapping;
  Lm628Pid::Config full = gains(0, 3, 0, 32767);
  full.wrap = true;
  for (int n = 0; n < 1000; ++n) wrapping.step(full, 32767);
  CHECK(wrapping.step(full, 0) == 32767);  // limited before it could wrap
}

TEST_CASE("lm628_pid forgets its sum where new coefficients have no integral") {
  Lm628Pid pid;
  pid.step(gains(0, 1, 0, 100), 2560);
  REQUIRE(pid.sum() == 10);
  pid.renew(gains(0, 1, 0, 100));
  CHECK(pid.sum() == 10);
  pid.renew(gains(1, 0, 0, 100));
  CHECK(pid.sum() == 0);
}
