// SPDX-License-Identifier: Apache-2.0
//
// The cascade of a servo drive in double precision: P position loop, PI speed loop, feed-forward of
// the reference's speed (Ellis, Control System Design Guide, P/PI position loop):
//   v* = K_p (x* - x) + v_ff
//   F* = K_v (v* - v) + z,   dz/dt = K_i (v* - v) + K_i/K_v (F - F*)
// F is F* within the limit; the last term keeps z from winding up while it is limited.
#pragma once

#include <algorithm>

namespace trammel::ideal {

struct Cascade {
  struct Config {
    double kp = 0;        // [1/s]
    double kv = 1;        // [N s/m]
    double ki = 0;        // [N/m]
    double limit = 1e9;   // [N]
    double period = 1e-3;  // [s]
  };
  struct State {
    double z = 0;  // [N]
  };
  struct In {
    double x_ref = 0, v_ff = 0;  // [m], [m/s]
    double x = 0, v = 0;         // [m], [m/s]
  };

  // For a mass: both poles of the speed loop at omega [rad/s], the position loop four times slower.
  static Config for_mass(double mass, double omega, double limit, double period) {
    return {omega / 4, 2 * mass * omega, mass * omega * omega, limit, period};
  }

  // The force [N] until the next call.
  static double step(const Config& c, State& s, const In& in) {
    const double error = c.kp * (in.x_ref - in.x) + in.v_ff - in.v;
    const double asked = c.kv * error + s.z;
    const double force = std::clamp(asked, -c.limit, c.limit);
    s.z += c.period * c.ki * (error + (force - asked) / c.kv);
    return force;
  }
};

}  // namespace trammel::ideal
