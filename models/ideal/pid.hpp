// SPDX-License-Identifier: Apache-2.0
//
// A PID controller of a position in double precision (Astrom and Haegglund, PID Controllers,
// parallel form with backward differences and back-calculation):
//   F* = K_p e + z + K_d de/dt,   dz/dt = K_i e + K_i/K_p (F - F*),   e = x* - x
// F is F* within the limit; the last term keeps z from winding up while it is limited.
#pragma once

#include <algorithm>

namespace trammel::ideal {

struct Pid {
  struct Config {
    double kp = 1;        // [N/m]
    double ki = 0;        // [N/(m s)]
    double kd = 0;        // [N s/m]
    double limit = 1e9;   // [N]
    double period = 1e-3;  // [s]
  };
  struct State {
    double z = 0;  // [N]
    double e = 0;  // [m], at the last call
  };

  // For a mass: all three poles at omega [rad/s].
  static Config for_mass(double mass, double omega, double limit, double period) {
    return {3 * mass * omega * omega, mass * omega * omega * omega, 3 * mass * omega, limit,
            period};
  }

  // The force [N] until the next call.
  static double step(const Config& c, State& s, double x_ref, double x) {
    const double e = x_ref - x;
    const double asked = c.kp * e + s.z + c.kd * (e - s.e) / c.period;
    const double force = std::clamp(asked, -c.limit, c.limit);
    s.z += c.period * c.ki * (e + (force - asked) / c.kp);
    s.e = e;
    return force;
  }
};

}  // namespace trammel::ideal
