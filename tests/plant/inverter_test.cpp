// SPDX-License-Identifier: Apache-2.0
//
// The inverter, and the link that supplies it.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "models/plant/axis.hpp"
#include "models/plant/dc_link.hpp"
#include "models/plant/inverter.hpp"

using namespace trammel::plant;

namespace {

Legs resolve(const Inverter& inverter, unsigned gates, std::array<double, 3> i, unsigned zero = 0,
             std::array<double, 3> emf = {}, unsigned opened = 0) {
  // A balanced motor: the leg whose current stays zero sits at its back-EMF above the star point.
  const auto keep_zero = [&](std::size_t k, const std::array<double, 3>& v) {
    const double others = v[0] + v[1] + v[2] - v[k];
    return 0.5 * (others + 3 * emf[k]);
  };
  return inverter.resolve(gates, i, zero, emf, keep_zero, opened);
}

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

TEST_CASE("a leg with one switch on is tied to its rail") {
  const Inverter inverter(InverterConfig{});
  const Legs legs = resolve(inverter, 0b110'001, {1, -0.5, -0.5});
  CHECK(legs.volt == std::array<double, 3>{311, 0, 0});
  CHECK(legs.floating == 0);
  CHECK_FALSE(legs.open);
}

TEST_CASE("with both switches off the sign of the current picks the diode") {
  const Inverter inverter(InverterConfig{});
  const Legs legs = resolve(inverter, 0, {1, -0.25, -0.75});
  CHECK(legs.volt == std::array<double, 3>{0, 311, 311});
  CHECK(legs.diode == std::array<int, 3>{1, -1, -1});
}

TEST_CASE("drops oppose the current in switches and diodes") {
  const Inverter inverter({311, 2, 1});
  CHECK(resolve(inverter, 0b110'001, {1, -0.5, -0.5}).volt == std::array<double, 3>{309, 2, 2});
  CHECK(resolve(inverter, 0b110'001, {-1, 0.5, 0.5}).volt == std::array<double, 3>{312, -1, -1});
  CHECK(resolve(inverter, 0, {1, -0.5, -0.5}).volt == std::array<double, 3>{-1, 312, 312});
}

TEST_CASE("a leg without current floats at the voltage that keeps it so") {
  const Inverter inverter(InverterConfig{});
  const Legs legs = resolve(inverter, 0b010'001, {1, -1, 0}, 4, {0, 0, 10});
  CHECK(legs.floating == 4);
  CHECK(legs.volt[2] == Approx(0.5 * (311 + 30)));
  CHECK_FALSE(legs.open);
}

TEST_CASE("a floating leg that would leave the rails conducts through its diode") {
  const Inverter inverter({24, 0, 0.5});
  // A and B low, the back-EMF of C positive: its upper diode opens when 1.5 e > 24.5 V.
  CHECK(resolve(inverter, 0b011'000, {0, 0, 0}, 4, {-8, -8, 16}).floating == 4);
  const Legs up = resolve(inverter, 0b011'000, {0, 0, 0}, 4, {-9, -9, 18});
  CHECK(up.diode[2] == -1);
  CHECK(up.volt[2] == 24.5);
  const Legs down = resolve(inverter, 0b011'000, {0, 0, 0}, 4, {1, 1, -2});
  CHECK(down.diode[2] == 1);
  CHECK(down.volt[2] == -0.5);
}

TEST_CASE("with all gates off current flows only above the link voltage") {
  const Inverter inverter(InverterConfig{});
  CHECK(resolve(inverter, 0, {0, 0, 0}, 7, {150, -150, 0}).open);
  const Legs legs = resolve(inverter, 0, {0, 0, 0}, 7, {160, -160, 0});
  CHECK_FALSE(legs.open);
  CHECK(legs.diode == std::array<int, 3>{-1, 1, 0});
  CHECK(legs.floating == 4);
}

TEST_CASE("one switch on alone lets the back-EMF brake through the diodes of its rail") {
  const Inverter inverter(InverterConfig{});
  CHECK(resolve(inverter, 0b001'000, {0, 0, 0}, 7, {0, 0, 0}).open);
  const Legs legs = resolve(inverter, 0b001'000, {0, 0, 0}, 7, {5, -10, 5});
  CHECK_FALSE(legs.open);
  CHECK(legs.diode[1] == 1);
}

TEST_CASE("both switches of a leg on is shoot-through") {
  CHECK(shoot_through(0b001'001));
  CHECK(shoot_through(0b100'100));
  CHECK_FALSE(shoot_through(0b010'101));
  CHECK_FALSE(shoot_through(0));
}

// A balanced star: a leg's current rises with its voltage above star point and back-EMF, and those
// of the floating legs do not change. The star point follows from the legs that conduct. An open
// phase floats beyond the rails too.
TEST_CASE("whatever the gates, currents and back-EMF, no leg conducts against its diodes") {
  std::mt19937 random(5);
  const auto any = [&random](double most) {
    return std::uniform_real_distribution<>(-most, most)(random);
  };
  int open = 0, floating = 0, clamped[2]{}, beyond = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const InverterConfig c{100, trial % 3 == 0 ? 0.0 : 2.0, trial % 3 == 1 ? 0.0 : 1.0};
    const Inverter inverter(c);
    unsigned gates = random() & 63u;
    gates &= ~(gates >> 3 & 7u);  // not both of a leg
    unsigned zero = random() & 7u;
    std::array<double, 3> i{any(1), any(1), any(1)}, emf{any(90), any(90), 0};
    emf[2] = -emf[0] - emf[1];
    if (trial % 4 == 0) zero = 7;
    const unsigned opened = trial % 5 == 0    ? 1u << random() % 3
                            : trial % 97 == 0 ? static_cast<unsigned>(random() & 7u)
                                              : 0;
    zero |= opened;
    for (std::size_t k = 0; k < 3; ++k) {
      if ((zero >> k & 1u) != 0) i[k] = 0;
    }
    const Legs legs = resolve(inverter, gates, i, zero, emf, opened);
    CAPTURE(trial, gates, zero, opened, i[0], i[1], i[2], emf[0], emf[1], emf[2], legs.volt[0],
            legs.volt[1], legs.volt[2], legs.floating, legs.open);
    const double top = c.dc_link + c.diode_drop, bottom = -c.diode_drop;
    double sum = 0;
    int conducting = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool upper = (gates >> k & 1u) != 0, lower = (gates >> (k + 3) & 1u) != 0;
      const bool floats = (legs.floating >> k & 1u) != 0, cut = (opened >> k & 1u) != 0;
      if (!floats) sum += legs.volt[k] - emf[k], ++conducting;
      INFO("leg " << k);
      REQUIRE(std::abs(legs.diode[k]) <= 1);
      if (cut) {
        REQUIRE(floats);
        REQUIRE(legs.diode[k] == 0);
      } else if (upper || lower) {  // the current's way through switch or diode
        REQUIRE_FALSE(floats);
        const double rail = upper ? c.dc_link : 0;
        const bool by_switch = upper ? i[k] > 0 : i[k] < 0;
        const double drop = i[k] == 0 ? 0 : by_switch ? c.switch_drop : c.diode_drop;
        REQUIRE(legs.volt[k] == Approx(i[k] > 0 ? rail - drop : rail + drop));
        REQUIRE(legs.diode[k] == 0);
      } else if (i[k] != 0) {
        REQUIRE(legs.diode[k] == (i[k] > 0 ? 1 : -1));
        REQUIRE(legs.volt[k] == (i[k] > 0 ? bottom : top));
      } else {
        REQUIRE(floats == (legs.diode[k] == 0));
      }
    }
    open += legs.open;
    if (legs.open) {  // at most one leg conducts, which then has no current: none may begin
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
          if (((opened >> a | opened >> b) & 1u) != 0) continue;
          const bool fixed = (legs.floating >> b & 1u) == 0;
          if (fixed && a != b) {
            REQUIRE(legs.volt[b] + emf[a] - emf[b] <= top + 1e-9);
            REQUIRE(legs.volt[b] + emf[a] - emf[b] >= bottom - 1e-9);
          }
          REQUIRE(emf[a] - emf[b] <= top - bottom + 1e-9);
        }
      }
      continue;
    }
    REQUIRE(conducting >= 2);
    const double star = sum / conducting;
    for (std::size_t k = 0; k < 3; ++k) {
      const double drive = legs.volt[k] - star - emf[k];
      INFO("leg " << k << " is driven by " << drive << " V");
      if ((legs.floating >> k & 1u) != 0) {
        ++floating;
        REQUIRE(drive == Approx(0).margin(1e-9));
        const bool within = legs.volt[k] <= top + 1e-9 && legs.volt[k] >= bottom - 1e-9;
        if ((opened >> k & 1u) == 0) REQUIRE(within);
        beyond += !within;
      } else if (i[k] == 0 && legs.diode[k] != 0) {  // the current that begins is the diode's
        ++clamped[legs.diode[k] > 0 ? 1 : 0];
        REQUIRE(drive * legs.diode[k] >= -1e-9);
      }
    }
  }
  CHECK(open > 100);
  CHECK(floating > 1000);
  CHECK(clamped[0] > 300);
  CHECK(clamped[1] > 300);
  CHECK(beyond > 100);
}

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
