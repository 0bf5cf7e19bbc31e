// SPDX-License-Identifier: Apache-2.0
//
// Laws of an axis with a rotary motor: power, salient torque, electrical angle, encoder, load.
#include "models/plant/rotary_axis.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

using namespace trammel::plant;

namespace {

constexpr double kPeriod = 1 / 48e6;  // [s]
constexpr unsigned kForward = 1u | 2u << 3 | 4u << 3;  // along phase a

// A motor of 24 V with 1024 lines and little friction.
RotaryAxisConfig small(int pole_pairs) {
  RotaryAxisConfig c;
  c.pole_pairs = pole_pairs;
  c.resistance_ohm = 0.6;
  c.inductance_d_h = c.inductance_q_h = 0.8e-3;
  c.flux_wb = 6e-3;
  c.inertia_kg_m2 = 12e-6;
  c.coulomb_nm = 0.003;
  c.dc_link_v = 24;
  return c;
}

void pass(RotaryAxis& axis, Clk end, unsigned gates) {
  if (axis.gates() != gates) axis.commit(axis.next(), gates);
  while (axis.next() <= end) axis.commit(axis.next(), gates);
}

Clk clocks(double seconds) { return static_cast<Clk>(std::llround(seconds / kPeriod)); }

std::string refusal(void (*set)(RotaryAxisConfig&)) {
  RotaryAxisConfig c;
  set(c);
  try {
    RotaryAxis axis(c, kPeriod);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("rotary axis: the electrical angle is the same after each whole turn, to the last bit") {
  for (int pairs = 1; pairs <= 50; ++pairs) {
    const RotaryAxisConfig c = small(pairs);
    const Pmlsm motor(motor_config(c));
    for (const double part : {0.0, 1.0 / 4096, 3071.0 / 4096}) {
      const SinCos first = motor.angle(part);
      for (const double turns : {1.0, 49.0, 1e6, -1e6}) {
        const SinCos later = motor.angle(turns + part);
        CAPTURE(pairs, part, turns);
        CHECK(later.sin == first.sin);
        CHECK(later.cos == first.cos);
      }
    }
    const SinCos pole = motor.angle(0.25 / pairs);  // a quarter of an electrical turn
    CHECK(pole.sin == Approx(1));
    CHECK(std::fabs(pole.cos) < 1e-12);
  }
}

TEST_CASE("rotary axis: the torque is the change of the co-energy with the angle") {
  RotaryAxisConfig c = small(7);
  c.inductance_q_h = 1.3e-3;
  const Pmlsm motor(motor_config(c));
  // W = 3/2 (L_d i_d^2/2 + lambda i_d + L_q i_q^2/2), the stator's current being held.
  const auto energy = [&](double turn, double alpha, double beta) {
    const SinCos a = motor.angle(turn);
    const double d = alpha * a.cos + beta * a.sin, q = beta * a.cos - alpha * a.sin;
    return 1.5 * (0.5 * c.inductance_d_h * d * d + c.flux_wb * d + 0.5 * c.inductance_q_h * q * q);
  };
  for (const double i_d : {-3.0, 0.0, 2.0}) {
    for (const double i_q : {-4.0, 1.5}) {
      const double turn = 0.137, step = 1e-6;
      const AlphaBeta i = Pmlsm::stator(i_d, i_q, motor.angle(turn));
      const double slope = (energy(turn + step, i.alpha, i.beta) -
                            energy(turn - step, i.alpha, i.beta)) / (2 * step);  // [J/rev]
      CAPTURE(i_d, i_q);
      CHECK(motor.force({turn, 0, i_d, i_q}) == Approx(slope).epsilon(1e-6));
      if (i_d == 0) {
        CHECK(motor.force({turn, 0, i_d, i_q}) == Approx(2 * kPi * c.torque_constant() * i_q));
      }
    }
  }
}

TEST_CASE("rotary axis: what the winding does not burn or store is work at the shaft") {
  for (const int pairs : {4, 7}) {
    for (const double inductance_q : {0.8e-3, 1.3e-3}) {
      RotaryAxisConfig c = small(pairs);
      c.inductance_q_h = inductance_q;
      c.viscous_nm_s = 1e-4;
      const Pmlsm motor(motor_config(c));
      const MotorState start{0.3, 20, -1.5, 3, 0, 0};  // 20 rev/s
      const SinCos a = motor.angle(start.x);
      const double u_d = -2, u_q = 8, span = 1e-6;
      const MotorState end = motor.span(start, a, Pmlsm::stator(u_d, u_q, a), {}).at(span);
      const auto stored = [&](const MotorState& s) {
        const double w = 2 * kPi * s.v;
        return 0.75 * (c.inductance_d_h * s.i_d * s.i_d + c.inductance_q_h * s.i_q * s.i_q) +
               0.5 * c.inertia_kg_m2 * w * w;
      };
      const double w = 2 * kPi * start.v;
      const double power = 1.5 * (u_d * start.i_d + u_q * start.i_q) -
                           1.5 * c.resistance_ohm * (1.5 * 1.5 + 3 * 3) -
                           (c.viscous_nm_s * w + c.coulomb_nm) * w;
      CAPTURE(pairs, inductance_q);
      CHECK((stored(end) - stored(start)) / span == Approx(power).epsilon(5e-3));
    }
  }
}

TEST_CASE("rotary axis: a load torque turns a free shaft by its inertia, for its time") {
  RotaryAxisConfig c = small(4);
  c.coulomb_nm = c.viscous_nm_s = 0;
  c.load_nm = -0.02;
  c.load_begin_s = 1e-3;
  c.load_end_s = 3e-3;
  RotaryAxis axis(c, kPeriod);
  pass(axis, clocks(4e-3), 0);
  const double speed = 0.02 / 12e-6 * 2e-3;  // [rad/s]
  CHECK(axis.state(clocks(4e-3)).speed_rad_s == Approx(speed).epsilon(1e-3));
  CHECK(axis.state(clocks(4e-3)).turn == Approx(speed * 2e-3 / (2 * kPi)).epsilon(2e-3));
}

TEST_CASE("rotary axis: a vector that stands draws the rotor to its pole, of N in a turn") {
  for (const int pairs : {4, 7}) {
    RotaryAxisConfig c = small(pairs);
    c.viscous_nm_s = 0.004;
    c.coulomb_nm = 0;
    c.resistance_ohm = 6;
    c.start_rev = 2 + 0.15 / pairs;
    RotaryAxis axis(c, kPeriod);
    pass(axis, clocks(0.1), kForward);
    CAPTURE(pairs);
    CHECK(axis.state(clocks(0.1)).turn == Approx(2).margin(1e-4));
  }
}

TEST_CASE("rotary axis: after a million turns it moves as at first, and the counts are those") {
  const auto run = [](double start, int lines) {
    RotaryAxisConfig c = small(7);
    c.encoder_lines = lines;
    c.start_rev = start + 0.03125;
    RotaryAxis axis(c, kPeriod);
    pass(axis, clocks(2e-3), kForward);
    return axis;
  };
  for (const int lines : {1024, 1000}) {
    const RotaryAxis near = run(0, lines), far = run(1e6, lines);
    const Clk n = clocks(2e-3);
    CAPTURE(lines);
    CHECK(std::fabs(near.state(n).turn - 0.03125) > 1e-3);  // it has turned
    CHECK(far.encoder().count() - near.encoder().count() == 1'000'000LL * 4 * lines);
    CHECK(far.encoder().z() == near.encoder().z());
    CHECK(far.state(n).turn - 1e6 == Approx(near.state(n).turn).margin(1e-7));
    CHECK(far.state(n).i_q_a == Approx(near.state(n).i_q_a).margin(1e-4));
  }
}

TEST_CASE("rotary axis: each turn has its counts and one index, one count wide") {
  RotaryAxisConfig c = small(7);
  c.coulomb_nm = c.viscous_nm_s = 0;
  c.flux_wb = 1e-3;  // too little for a current through the diodes
  c.external_torque_nm = -0.1;
  c.encoder_lines = 25;
  c.index_rev = 0.4;
  RotaryAxis axis(c, kPeriod);
  long marks = 0;
  std::int64_t last = axis.encoder().count();
  while (axis.encoder().count() < 300) {
    axis.commit(axis.next(), 0);
    if (axis.encoder().count() == last) continue;
    last = axis.encoder().count();
    CHECK(axis.encoder().z() == (last % 100 == 40));
    marks += axis.encoder().z();
  }
  CHECK(marks == 3);
  CHECK(axis.state(axis.next()).turn == Approx(3).margin(0.02));
}

TEST_CASE("rotary axis: a value that no axis can have is refused by its name and range") {
  CHECK(refusal([](RotaryAxisConfig&) {}).empty());
  CHECK(refusal([](RotaryAxisConfig& c) { c.pole_pairs = 0; }) ==
        "axis: pole_pairs: value 0 must be 1 to 50");
  CHECK(refusal([](RotaryAxisConfig& c) { c.pole_pairs = 51; }) ==
        "axis: pole_pairs: value 51 must be 1 to 50");
  CHECK(refusal([](RotaryAxisConfig& c) { c.pole_pairs = 50; }).empty());
  CHECK(refusal([](RotaryAxisConfig& c) { c.encoder_lines = 0; }) ==
        "axis: encoder_lines: value 0 must be 1 to 1000000");
  CHECK(refusal([](RotaryAxisConfig& c) { c.inertia_kg_m2 = 0; }) ==
        "axis: inertia_kg_m2: value 0 must be above 0");
  CHECK(refusal([](RotaryAxisConfig& c) { c.dc_link_v = -1; }) ==
        "axis: dc_link_v: value -1 must be 0 or above");
}
