// SPDX-License-Identifier: Apache-2.0
//
// Steppers of other values than Larson's: clocks, steps per revolution, stops and switches; and
// what each edge of the pins does.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "models/plant/stepper_axis.hpp"

using trammel::plant::StepperAxis;
using trammel::plant::StepperAxisConfig;
using trammel::plant::StepperConfig;
using trammel::plant::StepperMotor;

namespace {

void pass(StepperAxis& axis, std::int64_t n, bool forward = true, bool step = false) {
  while (axis.next() <= n) axis.drive(axis.next(), step, forward, false);
}

// A pulse of 2 us, with its direction set up before it.
void pulse(StepperAxis& axis, std::int64_t n, bool forward) {
  pass(axis, n - 60, forward);
  axis.drive(n - 60, false, forward, false);
  pass(axis, n, forward);
  axis.drive(n, true, forward, false);
  pass(axis, n + 99, forward, true);
  axis.drive(n + 100, false, forward, false);
}

StepperAxisConfig unbuffered() {
  StepperAxisConfig c;
  c.buffer.fitted = false;
  return c;
}

}  // namespace

TEST_CASE("stepper_axis moves the same in seconds at any clock") {
  for (const std::int64_t clock_ps : {20'000, 40'000, 100'000}) {
    StepperAxisConfig c;
    c.start = 123;
    c.clock_ps = clock_ps;
    StepperAxis axis(c);
    const auto clocks = [&](std::int64_t us) { return us * 1'000'000 / clock_ps; };
    for (int k = 0; k < 20; ++k) pulse(axis, clocks(100 + 250 * k), true);
    CAPTURE(clock_ps);
    // The buffer: 0.4 ms dead, then 464/s that rise by 2760/s each second: 9.6 by 19.5 ms.
    const double first = (std::sqrt(464.0 * 464 + 2 * 2760) - 464) / 2760;
    const auto leaves = static_cast<std::int64_t>(1e6 * (0.1e-3 + 0.4e-3 + first));
    StepperAxis early(c);
    for (const std::int64_t us : {leaves - 20, leaves + 20}) {
      for (int k = 0; k < 3 && us < leaves; ++k) pulse(early, clocks(100 + 250 * k), true);
      pass(early, clocks(us));
      CHECK(early.translated() == (us > leaves ? 124 : 123));
    }
    pass(axis, clocks(20'000));
    CHECK(axis.translated() == 132);
    pass(axis, clocks(500'000));
    CHECK(axis.state(clocks(500'000)).at == Approx(143).margin(1e-3));
  }
}

TEST_CASE("stepper_axis without its buffer tells the rate of pulses up to 20 ms apart") {
  for (const std::int64_t clock_ps : {10'000, 20'000, 40'000}) {
    StepperAxisConfig c = unbuffered();
    c.clock_ps = clock_ps;
    for (const int ms : {2, 15, 19, 21, 30}) {
      StepperAxis axis(c);
      const std::int64_t gap = ms * 1'000'000'000ll / clock_ps;
      for (int k = 0; k < 3; ++k) pulse(axis, 1000 + k * gap, true);
      pass(axis, 1000 + 2 * gap + 10);
      CAPTURE(clock_ps, ms);
      CHECK(axis.rate() == (ms < 20 ? Approx(1000.0 / ms) : Approx(0)));
    }
  }
}

TEST_CASE("stepper_axis without its buffer: the first pulse behind a pause tells no rate") {
  StepperAxis axis(unbuffered());
  std::int64_t n = 1000;
  for (int k = 0; k < 4; ++k, n += 62'500) pulse(axis, n, true);
  REQUIRE(axis.rate() == Approx(800));
  pass(axis, n += 250'000);  // 5 ms
  REQUIRE(axis.rate() == 0);
  pulse(axis, n, true);
  CHECK(axis.rate() == 0);
  pulse(axis, n + 50'000, true);
  CHECK(axis.rate() == Approx(1000));
}

TEST_CASE("stepper_axis: a pulse is a rising edge, the line of the buffer moves a clock later") {
  StepperAxisConfig config;
  config.buffer.busy_above = 2;
  StepperAxis axis(config);
  axis.drive(100, true, true, false);
  for (const std::int64_t n : {101, 102, 103}) axis.drive(n, true, true, false);
  CHECK(axis.waiting() == 1);
  for (int k = 1; k <= 2; ++k) {
    axis.drive(200 * k, false, true, false);
    axis.drive(200 * k + 100, true, true, false);
    CHECK(axis.waiting() == 1 + k);
    CHECK_FALSE(axis.buffer_busy());
  }
  CHECK(axis.next() == 501);
  axis.drive(501, true, true, false);
  CHECK(axis.buffer_busy());
}

TEST_CASE("stepper_axis: each switch is shown at the clock at which the rotor passes its place") {
  for (const bool high : {false, true}) {
    for (const bool out : {true, false}) {
      StepperAxisConfig c = unbuffered();
      c.switch_low = 20.5;
      c.switch_high = 80.5;
      c.switch_hysteresis = 7;
      c.start = out ? 50 : high ? 90 : 10;
      StepperAxis axis(c);
      const auto closed = [&] { return high ? axis.at_high() : axis.at_low(); };
      REQUIRE(closed() == !out);
      const bool forward = high == out;
      std::int64_t n = 1000, changed = 0;
      for (int k = 0; k < 60 && changed == 0; ++k, n += 500'000) {
        pulse(axis, n, forward);
        while (changed == 0 && axis.next() < n + 500'000) {
          const std::int64_t at = axis.next();
          axis.drive(at, false, true, false);
          if (closed() == out) changed = at;
        }
      }
      const double place = high ? (out ? 87.5 : 80.5) : (out ? 13.5 : 20.5);
      const StepperMotor::State s = axis.state(changed);
      CAPTURE(high, out, changed, s.at, s.speed, place);
      REQUIRE(changed > 0);
      // The event is a clock ahead of the commit that shows it, or the same.
      CHECK(std::fabs(s.at - place) <= 3 * std::fabs(s.speed) * 20e-9 + 1e-9);
    }
  }
}

TEST_CASE("stepper_axis: each stop is its overtravel behind where its switch closes") {
  for (const bool high : {false, true}) {
    StepperAxisConfig c = unbuffered();
    c.switch_low = 20.5;
    c.switch_high = 80.5;
    c.switch_hysteresis = 3;
    c.overtravel = 8;
    c.start = high ? 85 : 15;
    StepperAxis axis(c);
    const double stop = high ? 91.5 : 9.5;
    double farthest = c.start;
    for (int k = 0; k < 9; ++k) {
      pulse(axis, 1000 + k * 100'000, high);
      for (std::int64_t n = 1000 + k * 100'000; n < 101'000 + k * 100'000; n += 5'000) {
        pass(axis, n);
        const double at = axis.state(n).at;
        farthest = high ? std::max(farthest, at) : std::min(farthest, at);
      }
    }
    CAPTURE(high);
    CHECK(axis.hit_stop());
    CHECK(farthest == Approx(stop).margin(0.7));  // a span of 1 ms may end beyond it
  }
}

TEST_CASE("stepper_axis: the steps lost are those of its list, by their sign") {
  for (const bool forward : {true, false}) {
    StepperAxisConfig c = unbuffered();
    c.start = 3000;
    StepperAxis axis(c);
    for (int k = 0; k < 300; ++k) pulse(axis, 1000 + k * 9'000, forward);
    pass(axis, 60'000'000);
    int sum = 0;
    for (const auto& lost : axis.lost()) {
      CHECK(std::abs(lost.steps) == 10);
      sum += lost.steps;
    }
    CAPTURE(forward, axis.lost().size());
    REQUIRE(axis.lost().size() > 1);
    CHECK(sum == axis.steps_lost());
    CHECK(axis.state(60'000'000).at ==
          Approx(3000 + (forward ? 300 : -300) - sum).margin(0.01));
  }
}

TEST_CASE("stepper_motor: steps per revolution and the width of friction are its own") {
  StepperConfig c;
  c.steps = 200;
  c.friction = 0.01;
  c.friction_speed = 50;
  const StepperMotor motor(c);
  const double rad = 6.283185307179586 / 200;
  // Free of torque at its place, with the translator's rate: friction alone.
  for (const double speed : {-80.0, 10.0, 50.0}) {
    CAPTURE(speed);
    CHECK(motor.acceleration({4, speed}, 4, speed) ==
          Approx(-0.01 * std::tanh(speed / 50) / (c.inertia * rad)).epsilon(1e-9));
  }
  // Small swings: k/16 sin(2 pi e/10) over J and the angle of a step.
  const double e = 1e-3;
  CHECK(motor.acceleration({4 - e, 0}, 4, 0) ==
        Approx(c.stiffness_2 / 16 * 6.283185307179586 * e / 10 / (c.inertia * rad)).epsilon(1e-5));
}

TEST_CASE("stepper_motor: one long step of its integration is many short ones") {
  const StepperMotor motor((StepperConfig()));
  StepperMotor::State coarse{0.4, 300}, fine = coarse;
  for (int k = 0; k < 100; ++k) coarse = motor.after(coarse, 25e-6, 1, 200);
  for (int k = 0; k < 10'000; ++k) fine = motor.after(fine, 0.25e-6, 1, 200);
  CHECK(coarse.at == Approx(fine.at).margin(1e-5));
  CHECK(coarse.speed == Approx(fine.speed).margin(1e-2));
}
