// SPDX-License-Identifier: Apache-2.0
//
// Brushed DC motor behind a linear amplifier that saturates at its supply:
//   L di/dt = u - R i - k w                    u = clip(command supply, +-supply)
//   J dw/dt = k i - B w - T_c w/sqrt(w^2 + w_f^2) - T_ext,  dtheta/dt = w
// The current stays within its bounds, whatever voltage that takes, and the shaft loses its speed
// at a stop. Runge-Kutta steps of at most 16 us, a sixtieth of the shortest time constant of the
// default motor: the error is below 1e-9 of the current; bounds act at the end of a step. The
// defaults are a small motor as used with the LM628 around 1990; that of the application note is
// not known.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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
  double current_limit = std::numeric_limits<double>::infinity();  // [A], of the amplifier
};

struct DcMotorState {
  double theta = 0;  // [rad]
  double omega = 0;  // [rad/s]
  double i = 0;      // [A]
  double charge = 0, magnitude = 0;  // [C] integrals of i and of its magnitude
};

// Limits of current and shaft angle.
struct DcMotorBounds {
  static constexpr double kFree = std::numeric_limits<double>::infinity();
  double i_low = -kFree, i_high = kFree;          // [A]
  double theta_low = -kFree, theta_high = kFree;  // [rad]
};

class DcMotor {
 public:
  explicit DcMotor(const DcMotorConfig& c) : c_(c) {}

  const DcMotorConfig& config() const { return c_; }

  void load(double external_torque) { c_.external_torque = external_torque; }  // from now on

  // These bounds, narrowed by those of the amplifier.
  DcMotorBounds within(DcMotorBounds b) const {
    b.i_low = std::max(b.i_low, -c_.current_limit);
    b.i_high = std::min(b.i_high, c_.current_limit);
    return b;
  }

  // Voltage at the motor for a command; 1 is full scale.
  double voltage(double command) const {
    return std::fmax(-1.0, std::fmin(1.0, command)) * c_.supply;
  }

  DcMotorState after(const DcMotorState& s, double seconds, double volt) const {
    return after(s, seconds, volt, within({}));
  }

  DcMotorState after(const DcMotorState& s, double seconds, double volt,
                     const DcMotorBounds& b) const {
    const double steps = std::ceil(seconds / kStep);
    const double h = seconds / steps;
    Y y{s.theta, s.omega, s.i};
    double charge = 0, magnitude = 0;  // [A]
    for (double n = 0; n < steps; ++n) {
      const Y k1 = slope(y, volt, b);
      const Y y2 = add(y, k1, 0.5 * h);
      const Y k2 = slope(y2, volt, b);
      const Y y3 = add(y, k2, 0.5 * h);
      const Y k3 = slope(y3, volt, b);
      const Y y4 = add(y, k3, h);
      const Y k4 = slope(y4, volt, b);
      charge += y[2] + 2 * (y2[2] + y3[2]) + y4[2];
      magnitude += std::fabs(y[2]) + 2 * (std::fabs(y2[2]) + std::fabs(y3[2])) + std::fabs(y4[2]);
      for (std::size_t j = 0; j < y.size(); ++j) {
        y[j] += h * (1.0 / 6) * (k1[j] + 2 * (k2[j] + k3[j]) + k4[j]);
      }
      y = kept(y, b);
    }
    return {y[0], y[1], y[2], s.charge + h * (1.0 / 6) * charge,
            s.magnitude + h * (1.0 / 6) * magnitude};
  }

 private:
  using Y = std::array<double, 3>;
  static constexpr double kStep = 16e-6;  // [s]

  Y slope(const Y& y, double volt, const DcMotorBounds& b) const {
    const double w = y[1];
    const double torque = c_.constant * y[2] - c_.viscous * w - coulomb(w) - c_.external_torque;
    const double rise = (volt - c_.resistance * y[2] - c_.constant * w) / c_.inductance;
    const bool full = rise > 0 ? y[2] >= b.i_high : y[2] <= b.i_low;
    const bool held = torque > 0 ? y[0] >= b.theta_high && w >= 0 : y[0] <= b.theta_low && w <= 0;
    return {held ? 0 : w, held ? 0 : torque / c_.inertia, full ? 0 : rise};
  }

  double coulomb(double w) const {  // [N m]; a root less for a motor that has none
    if (c_.coulomb == 0) return 0;
    return c_.coulomb * (w / std::sqrt(w * w + c_.friction_speed * c_.friction_speed));
  }

  static Y kept(const Y& y, const DcMotorBounds& b) {
    const double theta = std::clamp(y[0], b.theta_low, b.theta_high);
    return {theta, theta == y[0] ? y[1] : 0, std::clamp(y[2], b.i_low, b.i_high)};
  }

  static Y add(const Y& a, const Y& b, double h) {
    return {a[0] + h * b[0], a[1] + h * b[1], a[2] + h * b[2]};
  }

  DcMotorConfig c_;
};

}  // namespace trammel::plant
