// SPDX-License-Identifier: Apache-2.0
//
// A five-phase stepper of the class of the Fujitsu 109 (Larson 1974, section III). Two and three of
// its phases are on in turn, in a cycle of ten steps; e is how many steps the rotor is behind:
//
//   J dw/dt = s T - friction,   T = T_m sin(2 pi e / 10) - b (w - w_cmd) within +-T(rate)
//   T_m = k / 16,   b = 2 zeta sqrt(k J)
//
// k and zeta are those of the number of phases that are on, T(rate) the table of torque against
// rate, s the share of its torque that the motor has. Damping is a torque of the same currents, so
// the limit and the share are those of the sum. Currents are impressed: a phase that is on loses
// R I^2. Beyond e = +-5 the rotor falls to a place ten steps
// away: steps are lost.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace trammel::plant {

inline constexpr double kLbIn = 0.112984829;  // [N m] of one pound-inch

struct StepperConfig {
  double inertia = 1.5e-4 * kLbIn;    // [kg m^2] rotor, screw and reflected table
  double stiffness_2 = 45 * kLbIn;    // [N m/rad] two phases on
  double stiffness_3 = 80 * kLbIn;    // three
  double damping_2 = 0.05;            // ratio; Larson says that three damp much stronger
  double damping_3 = 0.2;
  double friction = 0;                // [N m] of screw and slides, against motion
  double friction_speed = 20;         // [step/s] at which it is 76 % of that
  double torque_share = 1;            // of all that its currents do
  double phase_A = 3.5;               // of each phase that is on
  double winding_ohm = 0.4;           // of a phase
  int steps = 160;                    // per revolution
};

class StepperMotor {
 public:
  static constexpr double kCycle = 10;  // steps from a stable place to the next

  struct State {
    double at = 0;     // [step]
    double speed = 0;  // [step/s]
    double work = 0;   // [J] at the shaft; negative: it has braked more
  };

  explicit StepperMotor(const StepperConfig& c)
      : config_(c), step_rad_(6.283185307179586 / c.steps) {}

  // Most torque at a rate [step/s], in N m: linear between the points of the data sheet.
  double most_torque(double rate) const {
    struct Point {
      double rate, torque;
    };
    static constexpr std::array<Point, 5> kTable{
        {{0, 2.6}, {1000, 3.3}, {2000, 2.8}, {4000, 1.9}, {8000, 1.2}}};
    const double r = std::fabs(rate);
    double torque = kTable.back().torque;
    for (std::size_t k = 1; k < kTable.size(); ++k) {
      if (r > kTable[k].rate) continue;
      const Point &a = kTable[k - 1], &b = kTable[k];
      torque = a.torque + (b.torque - a.torque) * (r - a.rate) / (b.rate - a.rate);
      break;
    }
    return torque * kLbIn * config_.torque_share;
  }

  // Phases that are on where the translator stands at a step.
  static int phases(std::int64_t step) { return (step % 2) != 0 ? 3 : 2; }

  // [N m] of its currents, with the translator at `step`; told: the rate at which that steps.
  double torque(const State& s, std::int64_t step, double told) const {
    const bool three = phases(step) == 3;
    const double k = three ? config_.stiffness_3 : config_.stiffness_2;
    const double zeta = three ? config_.damping_3 : config_.damping_2;
    const double b = 2 * zeta * std::sqrt(k * config_.inertia);
    const double e = static_cast<double>(step) - s.at;
    const double t = k / 16 * std::sin(6.283185307179586 * e / kCycle) -
                     b * (s.speed - told) * step_rad_;
    const double most = most_torque(s.speed);
    return std::fmax(-most, std::fmin(most, config_.torque_share * t));
  }

  // [A] of the phases that are on.
  double current(std::int64_t step) const { return phases(step) * config_.phase_A; }
  double copper_loss(std::int64_t step) const {  // [W]
    return current(step) * config_.phase_A * config_.winding_ohm;
  }
  // [W] at the shaft; negative: it brakes.
  double power(const State& s, std::int64_t step, double told) const {
    return power(torque(s, step, told), s);
  }
  double power(double torque_N_m, const State& s) const { return torque_N_m * s.speed * step_rad_; }

  // [step/s^2]
  double acceleration(const State& s, std::int64_t step, double told) const {
    return acceleration(torque(s, step, told), s);
  }
  double acceleration(double torque_N_m, const State& s) const {
    double t = torque_N_m;
    if (config_.friction > 0) t -= config_.friction * std::tanh(s.speed / config_.friction_speed);
    return t / (config_.inertia * step_rad_);
  }

  // A classical Runge-Kutta step of h seconds.
  State after(const State& s, double h, std::int64_t step, double told) const {
    double work = 0;  // [W]
    const auto f = [&](double at, double speed, double share) {
      const State now{at, speed};
      const double t = torque(now, step, told);
      work += share * power(t, now);
      return acceleration(t, now);
    };
    const double v1 = s.speed, a1 = f(s.at, v1, 1);
    const double v2 = s.speed + h / 2 * a1, a2 = f(s.at + h / 2 * v1, v2, 2);
    const double v3 = s.speed + h / 2 * a2, a3 = f(s.at + h / 2 * v2, v3, 2);
    const double v4 = s.speed + h * a3, a4 = f(s.at + h * v3, v4, 1);
    return {s.at + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4),
            s.speed + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), s.work + h / 6 * work};
  }

 private:
  StepperConfig config_;
  double step_rad_;
};

}  // namespace trammel::plant
