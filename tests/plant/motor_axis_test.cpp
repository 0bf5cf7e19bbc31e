// SPDX-License-Identifier: Apache-2.0

#include "models/plant/motor_axis.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using trammel::plant::MotorAxis;

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
