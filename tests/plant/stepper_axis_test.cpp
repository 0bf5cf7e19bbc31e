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
void pass(StepperAxis& axis, std::int64_t n, bool forward = true, bool step = false) {
  while (axis.next() <= n) axis.drive(axis.next(), step, forward, false);
}

// n pulses, a gap of clocks apart, from clock `begin` on; the clock after the last.
std::int64_t pulses(StepperAxis& axis, std::int64_t begin, int n, std::int64_t gap, bool forward) {
  pass(axis, begin - 500, forward);
  axis.drive(begin - 500, false, forward, false);
  for (int k = 0; k < n; ++k) {
    const std::int64_t at = begin + k * gap;
    pass(axis, at, forward);
    axis.drive(at, true, forward, false);
    pass(axis, at + 103, forward, true);
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

TEST_CASE("stepper_axis: the upper switch closes beyond its place and opens at it") {
  StepperAxisConfig config;
  config.start = 5990;
  StepperAxis axis(config);
  std::int64_t n = 1000;
  const auto one = [&](bool forward) {
    n = pulses(axis, n, 1, 500'000, forward) + 5'000'000;
    pass(axis, n);
  };
  for (int k = 0; k < 9; ++k) {
    one(true);
    for (int clock = 0; clock < 2; ++clock) {
      pass(axis, ++n);
      CHECK_FALSE(axis.at_high());  // up to 5999
    }
  }
  one(true);
  CHECK(axis.at_high());
  one(false);
  CHECK(axis.at_high());  // 5999
  one(false);
  one(false);
  CHECK_FALSE(axis.at_high());
  CHECK_FALSE(axis.at_low());
}

TEST_CASE("stepper_axis: a pulse that comes with a flush is void, one behind it is not") {
  StepperAxis axis((StepperAxisConfig()));
  axis.drive(1000, true, true, true);
  CHECK(axis.waiting() == 0);
  axis.drive(2000, false, true, false);
  axis.drive(3000, true, true, false);
  CHECK(axis.waiting() == 1);
}

TEST_CASE("stepper_axis without its buffer: the rate is that of the pulses, until one is missing") {
  StepperAxisConfig config;
  config.buffer.fitted = false;
  StepperAxis axis(config);
  const std::int64_t last = pulses(axis, 1000, 5, 62'500, false) - 62'500;
  pass(axis, last + 62'500 * 14 / 10);
  CHECK(axis.rate() == Approx(-800));
  pass(axis, last + 62'500 * 16 / 10);
  CHECK(axis.rate() == 0);
}

TEST_CASE("stepper_axis: steps are lost where the rotor is half a step beyond five, not before") {
  StepperAxisConfig config;
  config.buffer.fitted = false;
  int losses = 0;
  for (std::int64_t gap = 9'000; gap <= 12'500; gap += 500) {
    StepperAxis axis(config);
    for (int k = 0; k < 300; ++k) {
      const int before = axis.steps_lost();
      const std::int64_t n = 1000 + k * gap;
      pulses(axis, n, 1, gap, true);
      if (axis.steps_lost() == before) continue;
      ++losses;
      const auto& lost = axis.lost().back();  // before the step of its edge
      const std::int64_t there = axis.translated() - (lost.edge <= n ? 1 : 0) - before;
      const double behind = std::fabs(static_cast<double>(there) - lost.at);
      CHECK(behind >= 5.5);
      CHECK(behind < 6.6);  // and the step since the last look
      CHECK(std::abs(axis.steps_lost() - before) == 10);
    }
  }
  CHECK(losses > 5);
}

TEST_CASE("stepper_axis: a weakened motor has that share of its own torque, until it has all") {
  StepperAxisConfig config;
  config.motor.friction = 0.02;
  StepperAxis strong(config);
  config.motor.torque_share = 0.05;
  StepperAxis weak(config);
  weak.weaken(500, 1);  // of little
  CHECK(std::llabs(weak.steps_lost()) == 0);
  std::int64_t end = pulses(weak, 1000, 200, 12'500, true) + 50'000'000;
  pass(weak, end);
  CHECK(weak.steps_lost() != 0);
  strong.weaken(500, 0.05);
  strong.weaken(600, 1);
  end = pulses(strong, 1000, 200, 12'500, true) + 50'000'000;
  pass(strong, end);
  CHECK(strong.steps_lost() == 0);
  strong.weaken(end, 0.05);
  pass(strong, pulses(strong, end + 1000, 200, 12'500, true) + 50'000'000);
  CHECK(strong.steps_lost() != 0);
}

TEST_CASE("stepper_axis: pulses during a flush are void, those behind it are not") {
  for (const bool fitted : {true, false}) {
    CAPTURE(fitted);
    StepperAxisConfig config;
    config.buffer.fitted = fitted;
    StepperAxis axis(config);
    std::int64_t n = 1000;
    for (const bool flush : {true, false}) {
      for (int k = 0; k < 5; ++k, n += 500'000) {
        pass(axis, n);
        axis.drive(n, true, true, flush);
        pass(axis, n + 249'999, true, true);
        axis.drive(n + 250'000, false, true, flush);
      }
      pass(axis, n += 50'000'000);
      CHECK(axis.translated() == (flush ? 400 : 405));
      CHECK(axis.waiting() == 0);
    }
  }
}

// Larson's is 1300 PPS at 0.5 lb-in, from 16 / sqrt(J): 16 = sqrt(2 (2.6 - 0.5) 2.5 / (2 pi / 160))
// is the energy of the torque at rest over a quarter of the cycle of ten steps. The rotor is pulled
// over half of it.
TEST_CASE("stepper_axis without its buffer starts and stops at 1300 PPS of 0.5 lb-in, not 1700") {
  const auto slips = [](double rate) {
    std::size_t count = 0;
    for (const int odd : {0, 1}) {
      StepperAxisConfig config;
      config.buffer.fitted = false;
      config.motor.friction = 0.5 * trammel::plant::kLbIn;
      config.start = 400 + odd;
      StepperAxis axis(config);
      pass(axis, pulses(axis, 1000, 400, std::llround(50e6 / rate), true) + 25'000'000);
      count += axis.lost().size();
    }
    return count;
  };
  for (const double rate : {300.0, 700.0, 1000.0, 1300.0}) CHECK(slips(rate) == 0);
  CHECK(slips(1700) > 0);
}

TEST_CASE("stepper_axis: without torque, or with one hundredth, it follows no move") {
  for (const double share : {0.0, 0.01}) {
    StepperAxisConfig config;
    config.motor.torque_share = share;
    StepperAxis axis(config);
    pass(axis, pulses(axis, 1000, 300, 125'000, true) + 50'000'000);
    CAPTURE(share);
    CHECK_FALSE(axis.lost().empty());
    CHECK(std::fabs(axis.state(90'000'000).at - 700) > 5);
    if (share == 0) CHECK(axis.state(90'000'000).at == 400);
  }
}

TEST_CASE("stepper_axis: its mean current is that of each step for as long as it lasts") {
  StepperAxisConfig config;
  config.buffer.fitted = false;
  StepperAxis axis(config);  // at 400, with two phases of 3.5 A on; at 401 with three
  CHECK(axis.mean_current(0) == 7);
  pulses(axis, 1000, 2, 12'500, true);
  CHECK(axis.mean_current(14'000) == Approx((7 * 1000 + 10.5 * 12'500 + 7 * 500) / 14'000));
}

TEST_CASE("stepper_axis: its peaks are those that one would see who looks at every clock's state") {
  for (const bool fitted : {true, false}) {
    StepperAxisConfig config;
    config.buffer.fitted = fitted;
    StepperAxis axis(config);
    double angle = 0, speed = 0, torque = 0, power = 0;
    int waiting = 0;
    const auto look = [&](std::int64_t n) {
      angle = std::max(angle, std::fabs(axis.load_angle(n)));
      speed = std::max(speed, std::fabs(axis.state(n).speed));
      torque = std::max(torque, std::fabs(axis.torque(n)));
      power = std::max(power, axis.power(n));
      waiting = std::max(waiting, axis.waiting());
    };
    for (std::int64_t n = 1'000; n < 5'000'000; n += 200) {  // to and fro, of 5 steps each
      const bool step = n % 125'000 < 400 && n % 2'500'000 < 5 * 125'000;
      while (axis.next() <= n) axis.drive(axis.next(), step, n < 2'500'000, false);
      axis.drive(n, step, n < 2'500'000, false);
      look(n);
    }
    CAPTURE(fitted);
    CHECK(axis.peaks().angle == Approx(angle).epsilon(1e-2));
    CHECK(axis.peaks().speed == Approx(speed).epsilon(1e-2));
    CHECK(axis.peaks().torque == Approx(torque).epsilon(1e-2));
    CHECK(axis.peaks().power == Approx(power).epsilon(2e-2));
    CHECK(axis.peaks().waiting == waiting);
    CHECK(angle > 1);
    CHECK(power > 0);
  }
}
