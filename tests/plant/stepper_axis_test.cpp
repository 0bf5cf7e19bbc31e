// SPDX-License-Identifier: Apache-2.0
#include "models/plant/stepper_axis.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

using trammel::plant::StepperAxis;
using trammel::plant::StepperAxisConfig;

namespace {

// Passes the axis' own events up to clock n.
void pass(StepperAxis& axis, std::int64_t n) {
  while (axis.next() <= n) axis.drive(axis.next(), false, true, false);
}

// n pulses, a gap of clocks apart, from clock `begin` on; the clock after the last.
std::int64_t pulses(StepperAxis& axis, std::int64_t begin, int n, std::int64_t gap, bool forward) {
  for (int k = 0; k < n; ++k) {
    const std::int64_t at = begin + k * gap;
    pass(axis, at);
    axis.drive(at, true, forward, false);
    pass(axis, at + 104);
    axis.drive(at + 104, false, forward, false);
  }
  return begin + n * gap;
}

}  // namespace

TEST_CASE("stepper_axis follows a move through its buffer and comes to rest at its place") {
  StepperAxis axis((StepperAxisConfig()));
  const std::int64_t end = pulses(axis, 1000, 300, 12'500, true);
  CHECK(axis.waiting() > 100);
  CHECK(axis.buffer_busy());
  pass(axis, end + 50'000'000);
  CHECK(axis.waiting() == 0);
  CHECK_FALSE(axis.buffer_busy());
  CHECK(axis.state(end + 50'000'000).at == Approx(700).margin(1e-3));
  CHECK(axis.next() == StepperAxis::kNever);  // it rests: nothing is to come
  CHECK(axis.steps_lost() == 0);
}

TEST_CASE("stepper_axis: the same state, whenever it is asked for between its events") {
  StepperAxis axis((StepperAxisConfig())), asked((StepperAxisConfig()));
  for (StepperAxis* one : {&axis, &asked}) one->drive(500, true, true, false);
  for (std::int64_t n = 600; n < 900'000; n += 7'000) {
    pass(axis, n);
    pass(asked, n);
    asked.state(n);
    asked.drive(n, false, true, false);  // no pulse: nothing is committed
    CHECK(asked.next() == axis.next());
    CHECK(asked.state(n).at == axis.state(n).at);
  }
}

TEST_CASE("stepper_axis: a switch closes beyond its place and opens at it, each at an event") {
  StepperAxisConfig config;
  config.start = 0;
  StepperAxis axis(config);
  std::int64_t n = 1000;
  int back = 0;
  for (; !axis.at_low() && back < 40; ++back) n = pulses(axis, n, 1, 500'000, false);
  CHECK(back == 14);  // -12.5, one pulse is on its way
  int on = 0;
  for (; axis.at_low() && on < 40; ++on) n = pulses(axis, n, 1, 500'000, true);
  CHECK(on == 5);  // -10.5: the last pulse back has left, too
  CHECK_FALSE(axis.at_high());
}

TEST_CASE("stepper_axis without its buffer loses ten steps at a rate that it does not reach") {
  StepperAxisConfig config;
  config.buffer.fitted = false;
  StepperAxis fast(config), slow(config);
  pass(fast, pulses(fast, 1000, 1000, 12'500, true) + 50'000'000);
  CHECK(std::abs(fast.steps_lost()) >= 10);
  CHECK(fast.steps_lost() % 10 == 0);
  REQUIRE_FALSE(fast.lost().empty());
  CHECK(fast.state(100'000'000).at == Approx(1400 - fast.steps_lost()).margin(0.01));
  pass(slow, pulses(slow, 1000, 1000, 62'500, true) + 50'000'000);
  CHECK(slow.steps_lost() == 0);
  CHECK(slow.state(200'000'000).at == Approx(1400).margin(0.01));
}

TEST_CASE("stepper_axis: a load above the motor's torque stalls it, and the stop holds it") {
  StepperAxisConfig config;
  config.motor.torque_share = 0.05;
  config.motor.friction = 0.02;
  StepperAxis weak(config);
  pass(weak, pulses(weak, 1000, 200, 12'500, true) + 50'000'000);
  CHECK(weak.steps_lost() != 0);
  StepperAxisConfig near;
  near.start = 5990;
  near.overtravel = 5;
  StepperAxis stopped(near);
  pass(stopped, pulses(stopped, 1000, 60, 125'000, true) + 50'000'000);
  CHECK(stopped.hit_stop());
  CHECK(stopped.at_high());
  CHECK(stopped.state(60'000'000).at <= 6004.5);
}

TEST_CASE("stepper_axis: a flush voids what waits") {
  StepperAxis axis((StepperAxisConfig()));
  const std::int64_t end = pulses(axis, 1000, 50, 12'500, true);
  pass(axis, end);
  const std::int64_t before = axis.translated();
  axis.drive(end, false, true, true);
  CHECK(axis.waiting() == 0);
  pass(axis, end + 30'000'000);
  CHECK(axis.translated() == before);
  CHECK_FALSE(axis.buffer_busy());
}
