// SPDX-License-Identifier: Apache-2.0
//
// A stepping motor; what its translator asks of step and direction, and the step that a breach
// costs; and the platform on its screw, by what the words of Larson's list of errors mean.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "models/plant/platform.hpp"
#include "models/plant/step_input.hpp"
#include "models/plant/stepper_axis.hpp"
#include "models/plant/stepper_motor.hpp"

using trammel::plant::kLbIn;
using trammel::plant::StepperConfig;
using trammel::plant::StepperMotor;
using trammel::plant::StepBreach;
using trammel::plant::StepInput;
using trammel::plant::StepInputConfig;
using trammel::plant::StepperAxis;
using trammel::plant::StepperAxisConfig;
using Kind = StepBreach::Kind;
using trammel::plant::platform_place;
using trammel::plant::PlatformConfig;

namespace {

constexpr double kStepS = 5e-6;

// From rest, the translator one step ahead: [step] off its place, every kStepS.
std::vector<double> ring(std::int64_t to, double seconds) {
  const StepperMotor motor((StepperConfig()));
  StepperMotor::State s{static_cast<double>(to - 1), 0};
  std::vector<double> off;
  for (double t = 0; t < seconds; t += kStepS) {
    off.push_back(s.at - static_cast<double>(to));
    s = motor.after(s, kStepS, to, 0);
  }
  return off;
}

// Times of rising zero crossings [s].
std::vector<double> crossings(const std::vector<double>& off) {
  std::vector<double> at;
  for (std::size_t k = 1; k < off.size(); ++k) {
    if (off[k - 1] < 0 && off[k] >= 0) at.push_back(static_cast<double>(k) * kStepS);
  }
  return at;
}

constexpr std::int64_t kClockPs = 20'000;

// Steps in the end, and the breach, of a pulse of so many clocks: direction turns forward so many
// clocks before its edge, and back so many behind it.
struct Outcome {
  int steps = 0;
  Kind kind = Kind::kNone;
};
Outcome outcome(const StepInputConfig& config, int width, int setup, int hold) {
  StepInput input(config, kClockPs);
  Outcome sum;
  const auto pins = [&](std::int64_t n, bool step, bool forward) {
    const StepInput::Seen seen = input.at(n, step, forward);
    sum.steps += seen.pulse - seen.taken;
    if (seen.breach.kind != Kind::kNone) sum.kind = seen.breach.kind;
  };
  pins(0, false, false);
  pins(10'000 - setup, setup == 0, true);
  if (setup != 0) pins(10'000, true, true);
  if (width < hold) {
    pins(10'000 + width, false, true);
    pins(10'000 + hold, false, false);
  } else {
    pins(10'000 + hold, true, false);
    pins(10'000 + width, false, false);
  }
  return sum;
}

}  // namespace

TEST_CASE("M-10 a single step with three phases: 2.5 ms, peak 0.52 at 4.4 ms, a ring of 8.6 ms") {
  const std::vector<double> three = ring(1, 0.1), two = ring(2, 0.1);
  const std::vector<double> at = crossings(three);
  REQUIRE(at.size() > 3);
  CHECK(std::fabs(at[0] - 2.5e-3) <= 0.2e-3);
  std::size_t peak = 0;
  for (std::size_t k = 0; k < three.size(); ++k) {
    if (three[k] > three[peak]) peak = k;
  }
  CHECK(std::fabs(static_cast<double>(peak) * kStepS - 4.4e-3) <= 0.3e-3);
  CHECK(std::fabs(three[peak] - 0.52) <= 0.05);
  CHECK(at[3] - at[2] == Approx(8.6e-3).epsilon(0.05));  // by then below 0.2 step
  // And it decays faster than with two.
  double late_three = 0, late_two = 0;
  for (std::size_t k = three.size() / 2; k < three.size(); ++k) {
    late_three = std::fmax(late_three, std::fabs(three[k]));
    late_two = std::fmax(late_two, std::fabs(two[k]));
  }
  CHECK(late_three < late_two / 10);
}

TEST_CASE("stepper_motor: with two phases on it rings with 11.5 ms") {
  const std::vector<double> at = crossings(ring(2, 0.2));
  REQUIRE(at.size() > 8);
  CHECK(at[8] - at[7] == Approx(11.5e-3).epsilon(0.02));
}

TEST_CASE("stepper_motor: stiffness is that of the data sheet, and torque no more than its table") {
  const StepperMotor motor((StepperConfig()));
  const double step = 2 * 3.14159265358979 / 160;
  CHECK(motor.torque({0.999, 0}, 1, 0) / (0.001 * step) == Approx(80 * kLbIn).epsilon(1e-4));
  CHECK(motor.torque({1.999, 0}, 2, 0) / (0.001 * step) == Approx(45 * kLbIn).epsilon(1e-4));
  CHECK(motor.torque({-1.5, 0}, 1, 0) == Approx(2.6 * kLbIn));
  CHECK(motor.torque({3.5, 0}, 1, 0) == Approx(-2.6 * kLbIn));
  CHECK(motor.torque({-1.5, 3000}, 1, 3000) == Approx(2.35 * kLbIn));  // at the rate of the rotor
  CHECK(motor.torque({3.5, -4000}, 1, -4000) == Approx(-1.9 * kLbIn));
  CHECK(motor.most_torque(3000) == Approx(2.35 * kLbIn));
  CHECK(motor.most_torque(-8000) == Approx(1.2 * kLbIn));
  CHECK(motor.most_torque(9000) == Approx(1.2 * kLbIn));
  CHECK(motor.torque({-5, 0}, 1, 0) < 0);  // more than five steps behind it is pulled on
}

TEST_CASE("stepper_motor: damping acts on the slip against the translator's rate, by its phases") {
  const StepperMotor motor((StepperConfig()));
  const StepperConfig c;
  for (const std::int64_t step : {10, 11}) {
    const double k = step == 11 ? 80 * kLbIn : 45 * kLbIn, zeta = step == 11 ? 0.2 : 0.05;
    const double at = static_cast<double>(step), per_s = 2 * zeta * std::sqrt(k / c.inertia);
    for (const double speed : {1500.0, -1500.0}) {
      CAPTURE(step, speed);
      CHECK(std::fabs(motor.acceleration({at, speed}, step, speed)) < 1e-6);
      CHECK(motor.acceleration({at, speed}, step, 0.9 * speed) == Approx(-per_s * 0.1 * speed));
      CHECK(motor.acceleration({at, 0}, step, 0.1 * speed) == Approx(per_s * 0.1 * speed));
    }
  }
}

// Damping is a torque of the same currents as the rest.
TEST_CASE("stepper_motor: pull and damping together are within the table, and of its share") {
  StepperConfig c;
  for (const double share : {1.0, 0.4, 0.0}) {
    c.torque_share = share;
    const StepperMotor motor(c);
    double most = 0;
    for (double e = -5; e <= 5; e += 0.25) {
      for (const double speed : {0.0, 700.0, -2500.0, 6000.0}) {
        for (const double told : {0.0, 400.0, -4000.0, 8000.0}) {
          const double t = motor.torque({11 - e, speed}, 11, told);
          CAPTURE(share, e, speed, told);
          REQUIRE(std::fabs(t) <= motor.most_torque(speed) * (1 + 1e-12));
          REQUIRE(t * share == Approx(share * share * StepperMotor({}).torque({11 - e, speed}, 11,
                                                                              told)));
          most = std::fmax(most, std::fabs(t));
        }
      }
    }
    CHECK(most == Approx(share * 3.3 * kLbIn).epsilon(0.1));
  }
}

TEST_CASE("stepper_motor: 3.5 A a phase, and at 8000 PPS the data sheet's 0.05 hp at the shaft") {
  const StepperMotor motor((StepperConfig()));
  CHECK(motor.current(10) == Approx(7));
  CHECK(motor.current(11) == Approx(10.5));
  // Its torque of 1.2 lb-in at that rate, printed with one digit of horsepower.
  CHECK(motor.power({8.5, 8000}, 11, 8000) / 745.7 == Approx(0.05).margin(0.01));
}

TEST_CASE("step_input: each time is kept to the clock, and a breach of it costs its step") {
  const StepInputConfig config{3e-6, 2e-6, 5e-6};  // 150, 100 and 250 clocks
  const struct {
    int width, setup, hold;
    Kind kind;
  } cases[] = {{150, 100, 250, Kind::kNone},  {149, 100, 250, Kind::kWidth},
               {150, 99, 250, Kind::kSetup},  {150, 100, 249, Kind::kHold},
               {400, 100, 300, Kind::kNone},  {400, 100, 249, Kind::kHold},
               {150, 0, 250, Kind::kSetup}};
  for (const auto& one : cases) {
    CAPTURE(one.width, one.setup, one.hold);
    const Outcome is = outcome(config, one.width, one.setup, one.hold);
    CHECK(is.kind == one.kind);
    CHECK(is.steps == (one.kind == Kind::kNone ? 1 : 0));
  }
  CHECK(outcome({0, 0, 0}, 1, 0, 2).steps == 1);  // of nothing nothing is a breach
}

TEST_CASE("step_input: a direction that turns between pulses costs nothing, near one its step") {
  // Two pulses forward, 250 us apart, and there and back between them, so far behind the first.
  for (const bool fitted : {true, false}) {
    for (const int behind : {20, 49, 50, 5'000, 12'300, 12'460, 12'499}) {
      StepperAxisConfig config;
      config.buffer.fitted = fitted;
      StepperAxis axis(config);
      bool last = false;
      const auto pins = [&](std::int64_t n, bool step, bool forward) {
        while (axis.next() < n) axis.drive(axis.next(), last, true, false);
        axis.drive(n, step, forward, false);
        last = step;
      };
      pins(1000, true, true);
      if (behind < 104) {  // in the pulse
        pins(1000 + behind, true, false);
        pins(1000 + behind + 1, true, true);
      }
      pins(1104, false, true);
      if (behind >= 104) {
        pins(1000 + behind, false, false);
        pins(1000 + behind + 1, false, true);
      }
      pins(13'500, true, true);
      pins(13'604, false, true);
      pins(30'000'000, false, true);
      const int breaches = behind < 50 || behind > 12'450 ? 1 : 0;
      CAPTURE(fitted, behind);
      CHECK(axis.breaches().size() == static_cast<std::size_t>(breaches));
      CHECK(axis.translated() == 402 - breaches);
      CHECK(axis.waiting() == 0);
    }
  }
}

TEST_CASE("step_input: four turns within 0.6 us cost the step whose hold or set-up they meet") {
  // The first pulse is 104 clocks wide; direction is looked at 50 clocks on either side of an edge.
  for (const int first : {15, 49, 50, 90, 3'065, 12'419, 12'420, 12'421, 12'465}) {
    StepInput input({}, kClockPs);
    int steps = 0, breaches = 0;
    const auto pins = [&](std::int64_t n, bool step, bool forward) {
      const StepInput::Seen seen = input.at(n, step, forward);
      steps += seen.pulse - seen.taken;
      breaches += seen.breach.kind != Kind::kNone ? 1 : 0;
    };
    constexpr std::int64_t kPulse = 1000, kNext = kPulse + 12'500, kWidth = 104;
    const auto high = [](std::int64_t n) {
      return (n >= kPulse && n < kPulse + kWidth) || n >= kNext;
    };
    pins(0, false, true);
    for (std::int64_t n = kPulse; n <= kNext; ++n) {
      const std::int64_t since = n - kPulse - first;
      pins(n, high(n), since < 0 || since >= 30 || since / 10 % 2 == 1);
    }
    const int lost = first < 50 || first + 30 > 12'450 ? 1 : 0;
    CAPTURE(first);
    CHECK(breaches == lost);
    CHECK(steps == 2 - lost);
  }
}

TEST_CASE("step_input: a buffer that has lost its only pulse stands, and takes the next one") {
  StepperAxisConfig config;
  config.input.width_s = 3e-6;
  StepperAxis axis(config);
  axis.drive(1000, true, true, false);
  CHECK(axis.waiting() == 1);
  axis.drive(1104, false, true, false);
  CHECK(axis.waiting() == 0);
  CHECK(axis.next() == 1105);  // it is no longer busy
  axis.drive(1105, false, true, false);
  CHECK(axis.next() == StepperAxis::kNever);
  axis.drive(5000, true, true, false);
  axis.drive(5200, false, true, false);
  CHECK(axis.waiting() == 1);
}

TEST_CASE("platform: of an ideal screw it is where the rotor is") {
  for (const double at : {12.0, 700.5, -3.0}) CHECK(platform_place({}, at, -1) == at);
}

TEST_CASE("platform: a place is off by its accuracy at most, and its two sides are apart") {
  PlatformConfig config;
  config.accuracy = 0.4;
  config.repeatability = 0.15;
  double most = 0, apart = 0;
  for (double place = 0; place <= 6000; place += 37) {
    most = std::fmax(most, std::fabs(platform_place(config, place, 0) - place));
    apart = std::fmax(apart, platform_place(config, place, -1) - platform_place(config, place, 1));
  }
  CHECK(most == Approx(0.4).epsilon(1e-3));
  CHECK(apart == Approx(0.15).epsilon(1e-3));
}
