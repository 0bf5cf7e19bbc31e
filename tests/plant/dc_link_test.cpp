// SPDX-License-Identifier: Apache-2.0
//
// A DC link that is not stiff: it sags under load and rises where the motor gives back.
#include "models/plant/dc_link.hpp"

#include <catch2/catch.hpp>

#include "models/plant/axis.hpp"

using namespace trammel::plant;

namespace {

constexpr double kPeriod = 20e-9;  // [s]

AxisConfig with_link() {
  AxisConfig c;
  c.start_m = 0.3;
  c.coulomb_n = c.viscous_n_s_m = 0;
  c.brake = false;
  c.supply_ohm = 5;
  c.dc_link_f = 2e-3;
  return c;
}

}  // namespace

TEST_CASE("a charged link sags to source less drop with the time constant R C") {
  DcLink link({300, 4, 1e-3, 0});
  for (int k = 0; k < 200; ++k) link.draw(10 * 20e-6, 20e-6);  // 10 A for 4 ms
  CHECK(link.volt() == Approx(260 + 40 * std::exp(-1.0)).epsilon(1e-9));
  for (int k = 0; k < 20000; ++k) link.draw(10 * 20e-6, 20e-6);
  CHECK(link.volt() == Approx(260));
}

TEST_CASE("what comes back only charges the capacitor, up to the chopper") {
  DcLink link({300, 4, 1e-3, 320});
  for (int k = 0; k < 100; ++k) link.draw(-5 * 20e-6, 20e-6);  // 5 A for 2 ms
  CHECK(link.volt() == Approx(310));
  CHECK(link.burnt() == 0);
  for (int k = 0; k < 300; ++k) link.draw(-5 * 20e-6, 20e-6);
  CHECK(link.volt() == 320);
  // 30 mC of which 10 raised the voltage; the rest came at 320 V.
  CHECK(link.burnt() == Approx(0.02 * 320).epsilon(1e-3));
}

TEST_CASE("the source lifts the link to its own voltage and no further, whatever comes back") {
  DcLink link({300, 4, 1e-3, 0});
  link.draw(0.1e-3, 1e-9);  // 0.1 V below the source
  REQUIRE(link.volt() == Approx(299.9).epsilon(1e-9));
  link.draw(-0.12e-3, 48e-6);  // 2.5 A: 0.12 V of the capacitor alone
  CHECK(link.volt() == Approx(300.02).epsilon(1e-9));
}

TEST_CASE("a stiff link keeps its voltage") {
  DcLink link({300, 0, 1e-3, 0});
  link.draw(1, 1e-3);
  CHECK(link.volt() == 300);
}

// The voltage lies along d, so the carriage stays.
//   L di/dt = 2/3 v - R i, C dv/dt = (V - v)/R_s - i
TEST_CASE("link and winding are one circuit") {
  AxisConfig c = with_link();
  c.pole_pitch_m = 0.03;  // 0.3 m: angle 0
  Axis axis(c, kPeriod);
  constexpr unsigned kGates = 1u | 2u << 3 | 4u << 3;
  const Clk end = 1'000'000;  // 20 ms
  axis.commit(1, kGates);
  while (axis.next() <= end) axis.commit(axis.next(), kGates);
  double v = c.dc_link_v, i = 0;
  const double h = 1e-7;
  for (int n = 0; n < 200000; ++n) {
    const double dv = ((c.dc_link_v - v) / c.supply_ohm - i) / c.dc_link_f;
    const double di = (2.0 / 3 * v - c.resistance_ohm * i) / c.inductance_d_h;
    v += h * dv;
    i += h * di;
  }
  const AxisState s = axis.state(end);
  CHECK(s.x_m == Approx(0.3).margin(1e-9));
  CHECK(c.dc_link_v - s.dc_link_v == Approx(c.dc_link_v - v).epsilon(1e-2));
  CHECK(s.i_a_a == Approx(i).epsilon(1e-3));
}

TEST_CASE("a pushed motor charges its link through the diodes, and no energy is lost") {
  AxisConfig c = with_link();
  c.dc_link_v = 40;
  c.external_force_n = -60;
  Axis axis(c, kPeriod);
  double copper_J = 0, before_W = 0;
  for (Clk n = 500; n <= 5'000'000; n += 500) {  // 100 ms in steps of 10 us
    while (axis.next() <= n) axis.commit(axis.next(), 0);
    const AxisState s = axis.state(n);
    const double now_W = 1.5 * c.resistance_ohm * (s.i_d_a * s.i_d_a + s.i_q_a * s.i_q_a);
    copper_J += 0.5 * (before_W + now_W) * 10e-6;
    before_W = now_W;
  }
  const AxisState s = axis.state(5'000'000);
  CHECK(s.dc_link_v > 45);
  const double link_J = 0.5 * c.dc_link_f * (s.dc_link_v * s.dc_link_v - 40 * 40);
  const double kinetic_J = 0.5 * c.mass_kg * s.v_m_s * s.v_m_s;
  const double coils_J = 0.75 * c.inductance_d_h * (s.i_d_a * s.i_d_a + s.i_q_a * s.i_q_a);
  CHECK(60 * (s.x_m - 0.3) == Approx(link_J + kinetic_J + coils_J + copper_J).epsilon(1e-3));
  CHECK(link_J > 1);
}

TEST_CASE("a source that changes moves a stiff link at once, and only charges another one") {
  DcLink stiff({300, 0, 1e-3, 0});
  stiff.set_source(120);
  CHECK(stiff.volt() == 120);
  DcLink link({300, 4, 1e-3, 0});
  link.set_source(340);
  CHECK(link.volt() == 300);
  link.draw(0, 4e-3);  // a time constant
  CHECK(link.volt() == Approx(340 - 40 * std::exp(-1.0)).epsilon(1e-9));
}

TEST_CASE("above its source a link is discharged by what the legs draw alone, and never below 0") {
  DcLink link({300, 4, 2e-3, 0});
  link.draw(-40e-3, 1e-3);
  REQUIRE(link.volt() == Approx(320));
  link.draw(10e-3, 1e-3);
  CHECK(link.volt() == Approx(315));
  link.draw(0, 1);
  CHECK(link.volt() == Approx(315));  // the rectifier takes nothing back
  DcLink drained({300, 4, 1e-3, 0});
  drained.draw(100, 1);
  CHECK(drained.volt() == 0);
  drained.draw(0, 1);
  CHECK(drained.volt() == Approx(300));
}
