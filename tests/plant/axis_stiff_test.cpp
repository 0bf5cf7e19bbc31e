// SPDX-License-Identifier: Apache-2.0
//
// Windings and carriages that are faster than the plant's usual spans of 6.25 us, against closed
// forms: such a series would grow without bound.
#include <catch2/catch.hpp>

#include <cmath>

#include "models/plant/axis.hpp"
#include "models/plant/spans.hpp"

using namespace trammel::plant;

namespace {

constexpr double kPeriod = 20e-9;           // [s]
constexpr unsigned kAOverBAndC = 1u | 2u << 3 | 4u << 3;

}  // namespace

TEST_CASE("a winding of 1 us follows its closed form") {
  AxisConfig c;
  c.resistance_ohm = 100;
  c.inductance_d_h = c.inductance_q_h = 1e-4;
  c.start_m = 0;
  c.locked = true;
  Axis axis(c, kPeriod);
  axis.commit(0, kAOverBAndC);
  const double last = c.dc_link_v / (1.5 * c.resistance_ohm);  // one winding over two
  for (Clk n = 10; n <= 50'000; n += 10) {
    while (axis.next() <= n) axis.commit(axis.next(), kAOverBAndC);
    const double t = static_cast<double>(n) * kPeriod;
    CAPTURE(n);
    REQUIRE(axis.state(n).i_a_a ==
            Approx(last * -std::expm1(-t * c.resistance_ohm / c.inductance_q_h)).epsilon(1e-4));
  }
}

TEST_CASE("a carriage with viscous friction of 10 us settles at its force over its friction") {
  AxisConfig c;
  c.mass_kg = 0.1;
  c.viscous_n_s_m = 10'000;
  c.coulomb_n = 0;
  c.mode_hz = 100;  // only 0.01 kg are not on the spring: 1 us
  c.mode_mass_ratio = 0.9;
  c.external_force_n = -20;
  c.start_m = 0.3;
  c.brake = false;
  Axis axis(c, kPeriod);
  while (axis.next() <= 50'000'000) axis.commit(axis.next(), 0);
  CHECK(axis.state(50'000'000).v_m_s == Approx(20.0 / 10'000).epsilon(1e-3));
  CHECK(axis.state(50'000'000).x_m == Approx(0.302).margin(1e-5));
}

TEST_CASE("spans are those of the fastest part of a motor, and some are too short") {
  AxisConfig c;
  CHECK(MotorRates(motor_config(c)).span() > 6.25e-6);
  c.resistance_ohm = 1000;
  CHECK(MotorRates(motor_config(c)).span() == Approx(0.1 * c.inductance_q_h / 1000));
  c.inductance_d_h = 1e-4;
  CHECK_THROWS_AS(Axis(c, kPeriod), std::invalid_argument);
}
