// SPDX-License-Identifier: Apache-2.0
//
// The precision controller in double precision (docs/precision.md, sections 4
// and 5): gains from the poles, the set point in closed form, the law of one axis at 16 kHz.
// Quantities are in counts and ticks, currents in LSB of i_q*; nothing is quantised, and only the
// current is limited.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace trammel::ideal {

class Precision {
 public:
  static constexpr double kTick = 62.5e-6;  // [s]
  static constexpr int kKnot = 32;          // ticks
  static constexpr double kDelay = 62;      // [ticks] from a knot to its point as the set point
  // Section 3: LSB of i_q* for 1 kg at 1 count/tick^2, for 1 N s/m at 1 count/tick.
  static constexpr double kPerMass = 0.026073 * (1 << 26) / 256;
  static constexpr double kPerViscous = 0.0066750 * (1 << 14) / 256;

  struct Poles {
    double w1 = 300, zeta = 0.7, w2 = 4000, w3 = 400;  // [rad/s], -, [rad/s], [rad/s]
  };
  struct Gains {
    double l1 = 0, l2 = 0, l3 = 0, k1 = 0, k2 = 0;
  };

  // Specification section 5: observer poles w2 twice and w3, feedback poles w1, zeta.
  static Gains gains(const Poles& p) {
    const double z = std::exp(-p.w2 * kTick), y = std::exp(-p.w3 * kTick), w = p.w1 * kTick;
    Gains g;
    g.l1 = 1 - z * z * y;
    g.l2 = 3 - 2 * g.l1 - z * z - 2 * z * y;
    g.l3 = 3 - 2 * z - y - g.l1 - g.l2;
    g.k1 = w * w;
    g.k2 = 2 * p.zeta * w;
    return g;
  }

  struct Config {
    Gains gains = Precision::gains({});
    double mass = 7.9;      // [kg]
    double viscous = 20;    // [N s/m]
    double coulomb = 16;    // i_q* LSB
    double lead = 6;        // [ticks]
    double knee = 16;       // friction is full at coulomb/(knee 64) counts per tick
    double limit = 2047;    // i_q* LSB
  };

  struct Point {
    double p = 0, v = 0, a = 0, j = 0;  // [count], per tick, per tick^2, per tick^3
  };

  // The set point after tick t >= 0, knot k at t = 32 k with the control point points[k] [count],
  // points.front() before: what each step of the points has become, a cubic of the time since.
  static Point set_point(const std::vector<double>& points, int t) {
    Point s;
    double sum[4] = {points.front(), 0, 0, 0};
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double step = points[k] - (k == 0 ? points.front() : points[k - 1]);
      const double n = t - kKnot * static_cast<double>(k);  // ticks since that knot
      for (int order = 0; order < 4; ++order) sum[order] += step * response(n, order);
    }
    s.p = sum[0];
    s.v = sum[1];
    s.a = sum[2];
    s.j = sum[3];
    return s;
  }

  struct State {
    double e1 = 0, e2 = 0, d = 0;        // [count], per tick, per tick^2
    double u1 = 0, u2 = 0, um = 0;       // per tick^2
    double e = 0, acc = 0, feedforward = 0;  // of the last tick
  };

  // One tick: s the set point, x the position [count], extra a current of the firmware.
  static double step(const Config& c, State& o, const Point& s, double x, double extra = 0) {
    o.e = s.p - x;
    const double a = s.a + c.lead * s.j, v = s.v + c.lead * s.a;
    const double n = o.e - o.e1;
    o.e1 += c.gains.l1 * n;
    o.e2 += c.gains.l2 * n;
    o.d += c.gains.l3 * n;
    o.acc = c.gains.k1 * o.e1 + c.gains.k2 * o.e2 + o.d;
    const double friction = std::clamp(v * c.knee * 64, -c.coulomb, c.coulomb);
    o.feedforward = c.mass * kPerMass * a + c.viscous * kPerViscous * v + friction + extra;
    const double wanted = c.mass * kPerMass * o.acc + o.feedforward;
    const double i_q = std::clamp(wanted, -c.limit, c.limit);
    const double used = o.acc - (wanted - i_q) / (c.mass * kPerMass);
    o.um += (o.u2 - o.um) / 4;
    o.u2 = o.u1;
    o.u1 = used;
    o.e2 += o.d - o.um;
    o.e1 += o.e2;
    return i_q;
  }

 private:
  // What a unit step of the points, taken n + 1 ticks ago, has become in the spline's p, v, a, j.
  // p is its four-fold sum of the fourth differences at knots 0 to 3: 1, -3, 3, -1.
  static double response(double n, int order) {
    constexpr double kDifference[4] = {1, -3, 3, -1};
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      const double m = n - kKnot * i + 1;  // terms that have been added since
      if (m > 0) sum += kDifference[i] * choose(m + 2 - order, 3 - order);
    }
    return sum / (kKnot * kKnot * kKnot);
  }

  // m (m - 1) ... / r!, of which m + r - 1 over r are the r-fold sums of ones.
  static double choose(double m, int r) {
    double c = 1;
    for (int i = 0; i < r; ++i) c *= (m - i) / (i + 1);
    return c;
  }
};

}  // namespace trammel::ideal
