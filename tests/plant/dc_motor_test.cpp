// SPDX-License-Identifier: Apache-2.0

#include "models/plant/dc_motor.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using trammel::plant::DcMotor;
using trammel::plant::DcMotorConfig;
using trammel::plant::DcMotorState;

TEST_CASE("dc_motor comes to the speed and current at which voltage and torque balance") {
  DcMotorConfig c;
  c.coulomb = 2e-3;
  c.external_torque = 0.01;
  const DcMotor motor(c);
  const DcMotorState s = motor.after({}, 2.0, 12.0);
  // k i = B w + T_c + T_ext and u = R i + k w
  const double i = (c.viscous * s.omega + c.coulomb + c.external_torque) / c.constant;
  REQUIRE(s.i == Approx(i).epsilon(1e-6));
  REQUIRE(12.0 == Approx(c.resistance * s.i + c.constant * s.omega).epsilon(1e-9));
}

TEST_CASE("dc_motor follows the exact step response of its two poles") {
  const DcMotorConfig c;
  const DcMotor motor(c);
  // w'' + a w' + b w = k u / (L J)
  const double a = c.resistance / c.inductance + c.viscous / c.inertia;
  const double b =
      (c.resistance * c.viscous + c.constant * c.constant) / (c.inductance * c.inertia);
  const double root = std::sqrt(a * a / 4 - b);
  const double p = -a / 2 + root, q = -a / 2 - root;
  const double end = c.constant * 10 / (c.inductance * c.inertia) / b;
  DcMotorState s;
  for (int n = 1; n <= 200; ++n) {
    s = motor.after(s, 256e-6, 10.0);
    const double t = n * 256e-6;
    const double exact = end * (1 + (q * std::exp(p * t) - p * std::exp(q * t)) / (p - q));
    REQUIRE(s.omega == Approx(exact).epsilon(1e-8));
  }
}

TEST_CASE("dc_motor at the limit of its current has the torque of that current, either way") {
  DcMotorConfig c;
  c.viscous = 0;
  c.current_limit = 1.5;
  const DcMotor motor(c);
  for (const double volt : {24.0, -24.0}) {
    const DcMotorState from = motor.after({}, 1e-3, volt);
    const DcMotorState to = motor.after(from, 10e-3, volt);
    CAPTURE(volt, from.omega, to.omega);
    CHECK(to.i == (volt > 0 ? 1.5 : -1.5));
    CHECK((to.omega - from.omega) / 10e-3 == Approx(c.constant * to.i / c.inertia).epsilon(1e-9));
  }
}

TEST_CASE("dc_motor's amplifier saturates at its supply") {
  const DcMotor motor({});
  REQUIRE(motor.voltage(0.5) == 12);
  REQUIRE(motor.voltage(1.7) == 24);
  REQUIRE(motor.voltage(-3) == -24);
}
