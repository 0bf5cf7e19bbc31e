// SPDX-License-Identifier: Apache-2.0
//
// Brushed DC motor behind a linear amplifier that saturates at its supply:
//   L di/dt = u - R i - k w                    u = clip(command supply, +-supply)
//   J dw/dt = k i - B w - T_c w/sqrt(w^2 + w_f^2) - T_ext,  dtheta/dt = w
// Runge-Kutta steps of at most 16 us, a sixtieth of the shortest time constant of the default
// motor: below 1e-9 of the current. The defaults are a small motor as used with the LM628 around
// 1990; the application note's own motor is not known.
#pragma once

#include <array>
#include <cmath>

namespace trammel::plant {

struct DcMotorConfig {
  double resistance = 2.0;      // [ohm]
  double inductance = 2e-3;     // [H]
  double constant = 0.05;       // [N m/A] and [V s/rad]
  double inertia = 1e-4;        // [kg m^2]
  double viscous = 1e-5;        // [N m s/rad]
  double coulomb = 0;           // [N m]
  double friction_speed = 0.1;  // [rad/s], width of the Coulomb transition
  double external_torque = 0;   // [N m], against positive motion
  double supply = 24;           // [V]
};

struct DcMotorState {
  double theta = 0;  // [rad]
  double omega = 0;  // [rad/s]
  double i = 0;      // [A]
};

class DcMotor {
 public:
  explicit DcMotor(const DcMotorConfig& c) : c_(c) {}

  const DcMotorConfig& config() const { return c_; }

  // Voltage at the motor for a command, 1 is full scale.
  double voltage(double command) const {
    return std::fmax(-1.0, std::fmin(1.0, command)) * c_.supply;
  }

  DcMotorState after(const DcMotorState& s, double seconds, double volt) const {
    const double steps = std::ceil(seconds / kStep);
    const double h = seconds / steps;
    Y y{s.theta, s.omega, s.i};
    for (double n = 0; n < steps; ++n) {
      const Y k1 = slope(y, volt);
      const Y k2 = slope(add(y, k1, 0.5 * h), volt);
      const Y k3 = slope(add(y, k2, 0.5 * h), volt);
      const Y k4 = slope(add(y, k3, h), volt);
      for (std::size_t j = 0; j < y.size(); ++j) {
        y[j] += h * (1.0 / 6) * (k1[j] + 2 * (k2[j] + k3[j]) + k4[j]);
      }
    }
    return {y[0], y[1], y[2]};
  }

 private:
  using Y = std::array<double, 3>;
  static constexpr double kStep = 16e-6;  // [s]

  Y slope(const Y& y, double volt) const {
    const double w = y[1];
    const double friction = w / std::sqrt(w * w + c_.friction_speed * c_.friction_speed);
    const double torque =
        c_.constant * y[2] - c_.viscous * w - c_.coulomb * friction - c_.external_torque;
    return {w, torque / c_.inertia,
            (volt - c_.resistance * y[2] - c_.constant * w) / c_.inductance};
  }

  static Y add(const Y& a, const Y& b, double h) {
    return {a[0] + h * b[0], a[1] + h * b[1], a[2] + h * b[2]};
  }

  DcMotorConfig c_;
};

}  // namespace trammel::plant
