// SPDX-License-Identifier: Apache-2.0
//
// A force that comes and goes at given times moves a carriage as Newton says.
#include <catch2/catch.hpp>

#include "models/plant/axis.hpp"

using namespace trammel::plant;

namespace {

constexpr double kPeriod = 20e-9;  // [s]

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

}  // namespace

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
