// SPDX-License-Identifier: Apache-2.0
//
// The stepper against Larson's estimates (1974, section III), of which acceptance test M-10 is one.
#include "models/plant/stepper_motor.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using trammel::plant::kLbIn;
using trammel::plant::StepperConfig;
using trammel::plant::StepperMotor;

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
