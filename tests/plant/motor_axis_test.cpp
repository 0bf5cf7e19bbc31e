// SPDX-License-Identifier: Apache-2.0
//
// A DC motor with its encoder, against closed forms, by default and of other values.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "models/plant/dc_motor.hpp"
#include "models/plant/motor_axis.hpp"
#include "models/plant/sine_encoder.hpp"

using namespace trammel::plant;

namespace {

constexpr double kTurnRad = 6.283185307179586;

MotorAxisConfig own() {
  MotorAxisConfig c;
  c.motor.resistance = 5;
  c.motor.inductance = 0.2e-3;
  c.motor.constant = 0.02;
  c.motor.inertia = 2e-6;  // 20 krad/s^2 and more
  c.motor.viscous = 0;
  c.motor.supply = 30;
  c.counts = 500;
  c.hysteresis = 0.6;
  c.clock_ps = 8'000;
  return c;
}

void pass(MotorAxis& axis, std::int64_t end, double command) {
  while (axis.next() <= end) axis.commit(axis.next(), command);
}

}  // namespace

TEST_CASE("motor_axis predicts every encoder edge at the first clock of its count") {
  MotorAxis axis({});
  axis.commit(1000, 0.25);
  std::int64_t count = 0;
  for (int edges = 0; edges < 2000;) {
    const std::int64_t n = axis.next();
    const double width = MotorAxis::kTurn / 4000;
    const double half = 0.5 + 0.1;
    const bool due = axis.state(n).theta >= (static_cast<double>(count) + half) * width;
    if (due) {
      REQUIRE(axis.state(n - 1).theta < (static_cast<double>(count) + half) * width);
      ++count;
      ++edges;
    }
    axis.commit(n, 0.25);
    REQUIRE(axis.count() == count);
  }
}

TEST_CASE("motor_axis is where the motor alone is, whatever is asked between") {
  trammel::plant::MotorAxisConfig config;
  MotorAxis axis(config);
  axis.commit(0, 0.5);
  while (axis.next() < 1'000'000) axis.commit(axis.next(), 0.5);
  const auto s = trammel::plant::DcMotor(config.motor).after({}, 0.02, 12);
  CHECK(axis.state(1'000'000).theta == Approx(s.theta).epsilon(1e-8));
  CHECK(axis.voltage() == 12);
}

TEST_CASE("motor_axis reverses, and shows its index once per revolution") {
  MotorAxis axis({});
  CHECK(axis.index());
  int indices = 0;
  axis.commit(0, 1);
  std::int64_t last = 0;
  bool was = true;
  while (axis.count() < 9000) {
    axis.commit(axis.next(), 1);
    REQUIRE(std::abs(axis.count() - last) <= 1);
    last = axis.count();
    if (axis.index() && !was) ++indices;
    was = axis.index();
  }
  CHECK(indices == 2);
  while (axis.count() > 0) axis.commit(axis.next(), -1);
  CHECK(axis.index());
}

TEST_CASE("motor_axis: a winding that opens has no current from that clock on, either way") {
  for (const double command : {1.0, -1.0}) {
    MotorAxis axis({});
    axis.commit(0, command);
    REQUIRE(std::abs(axis.state(20'000).i) > 0.1);
    axis.open(20'000, true);
    for (const std::int64_t n : {20'000, 20'001, 20'400, 100'000}) {
      CAPTURE(command, n);
      CHECK(axis.state(n).i == 0);
    }
    axis.open(100'000, false);
    CHECK(axis.state(120'000).i * command > 0.1);
  }
}

TEST_CASE("motor_axis takes a load from a clock on, and predicts the edges that it makes") {
  MotorAxis axis({});
  axis.load(5000, 0.05);
  const auto s = axis.state(1'000'000);
  CHECK(axis.state(5000).omega == 0);
  CHECK(s.omega < -1);  // the winding is shorted: it brakes, no more
  trammel::plant::MotorAxisConfig config;
  config.motor.external_torque = 0.05;
  CHECK(s.theta == Approx(trammel::plant::DcMotor(config.motor).after({}, 995'000 * 20e-9, 0).theta)
                       .epsilon(1e-8));
  while (axis.next() < 1'000'000) axis.commit(axis.next(), 0);
  CHECK(axis.count() < -10);
  MotorAxis pushed({});
  pushed.load(1000, 1);
  const double border = -0.6 * MotorAxis::kTurn / 4000;  // with half of the hysteresis
  std::int64_t first = pushed.next();
  for (; pushed.state(first).theta > border; first = pushed.next()) {  // still to come
    REQUIRE(first < 100'000);
    pushed.commit(first, 0);
    REQUIRE(pushed.next() > first);
    REQUIRE(pushed.count() == 0);
  }
  CHECK(pushed.state(first).theta <= border);
  CHECK(pushed.state(first - 1).theta > border);
  axis.load(1'000'000, 0);
  CHECK(axis.state(10'000'000).omega > s.omega);
}

TEST_CASE("motor_axis: counts, hysteresis and index are those of the encoder that is there") {
  MotorAxis axis(own());
  const double count = kTurnRad / 500;
  int edges = 0, indices = 0;
  std::int64_t n = 0, last = axis.count();
  axis.commit(0, 1);
  while (edges < 1500) {
    n = axis.next();
    // Up for more than a turn, then back through the hysteresis.
    const double asked = edges < 700 ? 1 : -1;
    if (axis.sensor().leaves(axis.state(n).theta)) {
      REQUIRE_FALSE(axis.sensor().leaves(axis.state(n - 1).theta));
      const double theta = axis.state(n).theta;
      axis.commit(n, asked);
      ++edges;
      const std::int64_t now = axis.count();
      REQUIRE(std::abs(now - last) == 1);
      const double boundary = 0.5 * static_cast<double>(now + last) * count;
      const double late = theta - boundary, sign = now > last ? 1 : -1;
      CAPTURE(edges, now, late / count);
      REQUIRE(sign * late >= 0.3 * count * (1 - 1e-9));
      REQUIRE(sign * late < 0.3 * count + std::fabs(axis.state(n).omega) * 8e-9 + 1e-12);
      REQUIRE(axis.index() == (now % 500 == 0));
      indices += axis.index() ? 1 : 0;
      last = now;
    } else {
      axis.commit(n, asked);
    }
  }
  CHECK(indices >= 3);
}

TEST_CASE("motor_axis: each edge of a shaft that reverses hard is found at its first clock") {
  MotorAxisConfig c = own();
  c.motor.inertia = 1e-7;  // 600 krad/s^2
  c.clock_ps = 50'000;     // and 40 us in a step of the integration
  MotorAxis axis(c);
  axis.commit(0, 1);
  for (int edges = 0; edges < 600;) {
    const std::int64_t n = axis.next();
    if (axis.sensor().leaves(axis.state(n).theta)) {
      CAPTURE(edges, n, axis.state(n).omega);
      REQUIRE_FALSE(axis.sensor().leaves(axis.state(n - 1).theta));
      ++edges;
    }
    axis.commit(n, edges / 7 % 2 == 0 ? 1 : -1);
  }
}

TEST_CASE("motor_axis: its clocks are those of its chip") {
  for (const std::int64_t clock_ps : {8'000, 20'000, 50'000}) {
    MotorAxisConfig c = own();
    c.clock_ps = clock_ps;
    MotorAxis axis(c);
    axis.commit(0, 0.5);
    const std::int64_t end = 2'000'000'000 / clock_ps;  // 2 ms
    pass(axis, end, 0.5);
    // 15 V less R i with a current that the inductance lets in within 40 us.
    const double constant = c.motor.constant * c.motor.constant / c.motor.resistance;
    const double last = 15 / c.motor.constant;
    const double omega = last * (1 - std::exp(-2e-3 * constant / c.motor.inertia));
    CAPTURE(clock_ps);
    CHECK(axis.state(end).omega == Approx(omega).epsilon(0.03));
  }
}

TEST_CASE("motor_axis: a command acts at its clock, also where the search for an edge goes on") {
  MotorAxis axis(own());
  axis.commit(0, 0);
  const std::int64_t n = axis.next();  // no edge: it rests
  REQUIRE_FALSE(axis.sensor().leaves(axis.state(n).theta));
  axis.commit(n, 0.5);
  CHECK(axis.voltage() == Approx(15));
}

TEST_CASE("motor_axis: the amplifier saturates at what is left of its supply, until it is whole") {
  MotorAxis axis(own());
  for (const double command : {1.5, -1.5, 0.5}) {
    axis.commit(axis.next(), command);
    const double whole = 30 * std::clamp(command, -1.0, 1.0);
    CAPTURE(command);
    CHECK(axis.voltage() == Approx(whole));
    for (const double share : {0.4, 0.5, 1.0}) {
      axis.supply(axis.next(), share);
      CAPTURE(share);
      CHECK(axis.voltage() == Approx(share * whole));
    }
  }
}

TEST_CASE("dc_motor: friction near rest is smoothed by its own width") {
  DcMotorConfig c;
  c.constant = 0;
  c.viscous = 0;
  c.coulomb = 0.01;
  c.friction_speed = 2;
  const DcMotor motor(c);
  for (const double omega : {0.5, 1.0, -4.0}) {
    const DcMotorState s = motor.after({0, omega, 0}, 1e-6, 0);
    const double torque = -0.01 * omega / std::sqrt(omega * omega + 4);
    CAPTURE(omega);
    CHECK((s.omega - omega) / 1e-6 == Approx(torque / c.inertia).epsilon(1e-4));
  }
}

TEST_CASE("dc_motor: a shaft at its stop leaves it with the speed that it has, and no further") {
  DcMotorConfig c;
  c.viscous = 0;
  const DcMotor motor(c);
  for (const double side : {-1.0, 1.0}) {
    DcMotorBounds bounds;
    bounds.theta_low = -3;
    bounds.theta_high = 3;
    // Pushed to the stop by 2 A, yet moving away from it.
    const DcMotorState s = motor.after({side * 3, -side * 5, side * 2}, 1e-5, side * 4, bounds);
    CAPTURE(side);
    CHECK(s.theta == Approx(side * (3 - 5e-5)).epsilon(1e-6));
    CHECK(-side * s.omega == Approx(5 - 0.05 * 2 / 1e-4 * 1e-5).epsilon(1e-3));
    const DcMotorState held = motor.after({side * 3, 0, side * 2}, 1e-3, side * 24, bounds);
    CHECK(held.theta == side * 3);
    CHECK(held.omega == 0);
  }
}

TEST_CASE("sine_encoder: its signals are those of its lines, amplitude, centre and offsets") {
  SineEncoderConfig c;
  c.lines = 50;
  c.amplitude = 0.8;
  c.centre = 1.2;
  c.cosine_offset = 0.07;
  c.sine_offset = -0.11;
  const SineEncoder encoder(c);
  CHECK(encoder.counts() == 200);
  // In the middle of the quarter of a line in which both are low.
  for (int k = -300; k < 300; ++k) {
    const double turns = k / 240.0, line = kTurnRad * (50 * turns + 0.625);
    const SineEncoder::Signals s = encoder.signals(turns * kTurnRad);
    CAPTURE(k);
    CHECK(s.cosine == Approx(1.27 + 0.8 * std::cos(line)).margin(1e-9));
    CHECK(s.sine == Approx(1.09 + 0.8 * std::sin(line)).margin(1e-9));
    const double off = 50 * std::fabs(turns - std::round(turns));  // lines from the marker
    CHECK(s.marker == Approx(1.2 - 0.8 * std::max(-1.0, 1 - 2 * off)).margin(1e-9));
  }
}

TEST_CASE("sine_encoder: the count follows the angle both ways, each change of a line is told") {
  for (const bool swapped : {false, true}) {
    SineEncoderConfig c;
    c.lines = 7;
    c.swapped = swapped;
    SineEncoder encoder(c);
    CHECK_FALSE((encoder.a() || encoder.b() || encoder.marker()));
    const double count = kTurnRad / 28;
    int markers = 0;
    for (int k = 0; k <= 8000; ++k) {
      // Two turns up, four down.
      const double counts = k <= 2000 ? 0.028 * k : 56 - 0.0187 * (k - 2000);
      const bool a = encoder.a(), b = encoder.b(), marker = encoder.marker();
      const bool told = encoder.leaves(counts * count);
      encoder.follow(counts * count);
      const bool changed = a != encoder.a() || b != encoder.b() || marker != encoder.marker();
      CAPTURE(swapped, k, counts);
      REQUIRE(told == changed);
      REQUIRE(std::fabs(static_cast<double>(encoder.count()) - counts) < 0.52);
      markers += marker != encoder.marker() ? 1 : 0;
    }
    CHECK(markers == 12);
  }
}

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
