// SPDX-License-Identifier: Apache-2.0
//
// Permanent-magnet linear synchronous motor with its carriage (Kung et al. 2012, section 2):
//   L_d di_d/dt = v_d - R i_d + w L_q i_q               w = pi v / tau, theta_e = pi x / tau
//   L_q di_q/dt = v_q - R i_q - w L_d i_d - w lambda_f
//   M dv/dt = F_e - B v - (F_c + F_s exp(-(v/v_s)^2)) v/sqrt(v^2 + v_f^2) - F_cog sin(2 pi x/tau)
//             - F_h sin(2 pi h x/tau + 1) - c (x - x_c) - F_ext,  dx/dt = v
//   F_e = 3 pi/(2 tau) ((L_d - L_q) i_d + lambda_f) i_q
// With an elastic mode, part m of the mass hangs on a spring and a damper, by y ahead of its place:
//   m (dv/dt + d2y/dt2) = -k y - d dy/dt = -F_y;   M is the rest, and has F_y more.
// A rotary motor of p pole pairs obeys the same equations with x in revolutions (rotary_axis.hpp):
// tau = 1/(2 p), mass (2 pi)^2 J, and 2 pi T in the place of a force.
// Under constant phase voltages the solution over a short span (spans.hpp) is a Taylor series in
// time: currents and speed to t^3, position to t^4. Over 1/80 of a time constant its truncation
// error is below 1e-9 of the current.
#pragma once

#include <array>
#include <cmath>

#include "models/plant/trig.hpp"

namespace trammel::plant {

struct PmlsmConfig {
  double resistance = 27;          // [ohm]
  double inductance_d = 23.3e-3;   // [H]
  double inductance_q = 23.3e-3;   // [H]
  double force_constant = 79.9;    // [N/A], peak of the amplitude-invariant i_q
  double pole_pitch = 30.5e-3;     // [m], north to south: half an electrical revolution
  double mass = 2.5;               // [kg], moving
  double coulomb = 3.0;            // [N]
  double viscous = 20;             // [N s/m]
  double cogging = 0;              // [N]
  double friction_speed = 0.5e-3;  // [m/s], width of the Coulomb transition
  double external_force = 0;       // [N], against positive motion
  double stribeck = 0;             // [N], of the friction at rest above the Coulomb friction
  double stribeck_speed = 5e-3;    // [m/s], at which 1/e of it is left
  double harmonic_force = 0;       // [N], of the cogging
  double harmonic = 2;             // its number
  double cable = 0;                // [N/m], of a cable that pulls back
  double cable_rest = 0;           // [m], where it does not
  double mode_mass = 0;            // [kg], on a spring and a damper, beside `mass`; 0: none
  double mode_stiffness = 0;       // [N/m]
  double mode_damping = 0;         // [N s/m]
  double mode_frequency = 0;       // [Hz]
  int pole_pairs = 0;              // of a rotary motor, for an exact angle; 0: by the pole pitch
  double speed_room = 0.1;         // [m/s], for which acceleration_bound() allows

  // Takes a share of the mass for a mode. Frequency [Hz] and damping, of the critical one, are
  // those of the two swinging against each other, with the reduced mass r (1 - r) M.
  void add_mode(double frequency, double damping, double share) {
    const double reduced = share * (1 - share) * mass, w = 2 * kPi * frequency;
    mode_frequency = frequency;
    mode_mass = share * mass;
    mode_stiffness = reduced * w * w;
    mode_damping = 2 * damping * reduced * w;
    mass -= mode_mass;
  }
};

struct MotorState {
  double x = 0, v = 0;      // [m], [m/s]
  double i_d = 0, i_q = 0;  // [A]
  double y = 0, y_speed = 0;  // of the mode [m], [m/s]
};

struct AlphaBeta {
  double alpha = 0, beta = 0;
};

// Amplitude-invariant Clarke of three phase values (Kung eq. 7); the common part drops out.
inline AlphaBeta clarke(const std::array<double, 3>& p) {
  return {(2 * p[0] - p[1] - p[2]) * (1.0 / 3), (p[1] - p[2]) * 0.57735026918962576};
}

inline std::array<double, 3> to_phases(const AlphaBeta& s) {
  const double half = 0.86602540378443865 * s.beta;
  return {s.alpha, -0.5 * s.alpha + half, -0.5 * s.alpha - half};
}

// What holds the carriage or the currents during a span.
struct Hold {
  bool carriage = false;  // against a stop: v = 0
  bool currents = false;  // no leg conducts: i = 0
};

// One span of motion: series in the time since its start.
struct Span {
  std::array<double, 5> x{};
  std::array<double, 4> v{}, i_d{}, i_q{};
  SinCos angle{};  // electrical angle at the start
  bool elastic = false;
  std::array<double, 5> y{};  // of the mode; 0 without one
  std::array<double, 4> y_speed{};

  static double quartic(const std::array<double, 5>& c, double t) {
    return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])));
  }
  double position(double t) const { return quartic(x, t); }
  static double cubic(const std::array<double, 4>& c, double t) {
    return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
  }
  double speed(double t) const { return cubic(v, t); }
  MotorState at(double t) const {
    MotorState s{position(t), cubic(v, t), cubic(i_d, t), cubic(i_q, t), 0, 0};
    if (elastic) s.y = quartic(y, t), s.y_speed = cubic(y_speed, t);
    return s;
  }
};

class Pmlsm {
 public:
  explicit Pmlsm(const PmlsmConfig& c)
      : c_(c),
        k_(kPi / c.pole_pitch),
        turns_per_m_(c.pole_pairs != 0 ? c.pole_pairs : 0.5 / c.pole_pitch),
        lambda_(2 * c.pole_pitch * c.force_constant / (3 * kPi)),  // Kung eq. 5
        force_(1.5 * k_),
        inv_ld_(1 / c.inductance_d),
        inv_lq_(1 / c.inductance_q),
        inv_mass_(1 / c.mass),
        saliency_(std::fmax(c.inductance_d, c.inductance_q) /
                  std::fmin(c.inductance_d, c.inductance_q)) {}

  // From the next span on [N], against positive motion.
  void set_external_force(double force) { c_.external_force = force; }

  const PmlsmConfig& config() const { return c_; }
  double flux() const { return lambda_; }                    // [Wb]
  double angular_speed(double v) const { return k_ * v; }    // [rad/s]
  double back_emf_constant() const { return k_ * lambda_; }  // [V s/m], phase peak
  // Kung eq. 3; with i_d = 0 or L_d = L_q it is Kung eq. 4.
  double force(const MotorState& s) const {
    return force_ * ((c_.inductance_d - c_.inductance_q) * s.i_d + lambda_) * s.i_q;
  }
  SinCos angle(double x) const { return sin_cos_turns(x * turns_per_m_); }

  // Force on the carriage at speed 0, where friction is none: it moves the carriage off a stop.
  double push(const MotorState& s) const {
    const SinCos a = angle(s.x);
    return force(s) - c_.cogging * 2 * a.sin * a.cos - c_.external_force - held_back(s.x) +
           mode_force(s.y, s.y_speed);
  }

  // Stops the carriage at once; what hangs on its spring goes on.
  void halt(MotorState& s) const {
    if (c_.mode_mass != 0) s.y_speed += s.v;
    s.v = 0;
  }

  // Largest acceleration within `span` seconds for phase voltages below `volt`. What flux linkage
  // the currents make may turn from the axis of the larger inductance to that of the smaller.
  double acceleration_bound(const MotorState& s, double volt, double span) const {
    const double speed = std::fabs(s.v), top = speed + c_.speed_room;
    const double slew = 2 * (volt + k_ * lambda_ * top) * std::fmax(inv_ld_, inv_lq_);
    const double current = saliency_ * (std::fabs(s.i_d) + std::fabs(s.i_q)) + slew * span;
    const double flux = lambda_ + std::fabs(c_.inductance_d - c_.inductance_q) * current;
    const double mode_speed = std::fabs(s.y_speed) + speed + c_.speed_room;
    return inv_mass_ * (mode_force(std::fabs(s.y) + mode_speed * span, mode_speed) +
                        force_ * flux * current + c_.viscous * top + c_.coulomb +
                        std::fabs(c_.cogging) + std::fabs(c_.external_force) + c_.stribeck +
                        std::fabs(c_.harmonic_force) + c_.cable * std::fabs(s.x - c_.cable_rest) +
                        c_.cable * top * span);
  }

  // Back-EMF vector in the stator frame.
  AlphaBeta emf(const MotorState& s, const SinCos& a) const {
    const double e = k_ * s.v * lambda_;
    return {-e * a.sin, e * a.cos};
  }

  // Stator-frame current derivative under the phase voltage u.
  AlphaBeta current_slope(const MotorState& s, const SinCos& a, const AlphaBeta& u) const {
    const double w = k_ * s.v;
    const double u_d = u.alpha * a.cos + u.beta * a.sin;
    const double u_q = u.beta * a.cos - u.alpha * a.sin;
    const double d =
        (u_d - c_.resistance * s.i_d + w * c_.inductance_q * s.i_q) * inv_ld_ - w * s.i_q;
    const double q =
        (u_q - c_.resistance * s.i_q - w * (c_.inductance_d * s.i_d + lambda_)) * inv_lq_ +
        w * s.i_d;
    return {d * a.cos - q * a.sin, d * a.sin + q * a.cos};
  }

  // Derivative of the current along the stator direction n per volt along n.
  double slope_per_volt(const SinCos& a, const AlphaBeta& n) const {
    const double d = n.alpha * a.cos + n.beta * a.sin;
    const double q = n.beta * a.cos - n.alpha * a.sin;
    return d * d * inv_ld_ + q * q * inv_lq_;
  }

  // Series from state s under the constant stator-frame voltage u; writes every member of f.
  void span(Span& f, const MotorState& s, const SinCos& a, const AlphaBeta& u, Hold hold) const {
    f.angle = a;
    f.x[0] = s.x;
    f.v = {hold.carriage ? 0 : s.v, 0, 0, 0};
    f.i_d = {hold.currents ? 0 : s.i_d, 0, 0, 0};
    f.i_q = {hold.currents ? 0 : s.i_q, 0, 0, 0};
    Push p;
    p.u_d[0] = u.alpha * a.cos + u.beta * a.sin;
    p.u_q[0] = u.beta * a.cos - u.alpha * a.sin;
    p.cog[0] = 2 * a.sin * a.cos;
    p.cog_cos[0] = 1 - 2 * a.sin * a.sin;
    const double width2 = c_.friction_speed * c_.friction_speed;
    p.inv_r = 1 / std::sqrt(f.v[0] * f.v[0] + width2);
    p.slope = width2 * p.inv_r * p.inv_r * p.inv_r;
    if (c_.stribeck != 0) add_stribeck(p, f.v[0]);
    if (c_.harmonic_force != 0) {
      p.harmonic[0] = std::sin(harmonic_angle(s.x));
      p.harmonic_cos[0] = std::cos(harmonic_angle(s.x));
    }
    if (c_.mode_mass != 0) {
      f.y[0] = s.y;
      f.y_speed[0] = s.y_speed;
      f.elastic = true;
    }
    extend<0>(f, p, hold);
    extend<1>(f, p, hold);
    extend<2>(f, p, hold);
    f.x[4] = 0.25 * f.v[3];
    if (f.elastic) f.y[4] = 0.25 * f.y_speed[3];
  }
  Span span(const MotorState& s, const SinCos& a, const AlphaBeta& u, Hold hold) const {
    Span f;
    span(f, s, a, u, hold);
    return f;
  }

  // Electrical angle at place x of a span: that of its start turned on, where it turns little.
  SinCos angle_at(const Span& f, double x) const {
    const double a = k_ * (x - f.x[0]);
    const double z = a * a;
    if (z > 1e-3) return angle(x);
    const double s = a * (1 - z * (1.0 / 6) * (1 - z * 0.05));
    const double c = 1 - 0.5 * z * (1 - z * (1.0 / 12) * (1 - z * (1.0 / 30)));
    return {f.angle.sin * c + f.angle.cos * s, f.angle.cos * c - f.angle.sin * s};
  }

  // By how much it turns at most within t seconds [rad].
  double turn_bound(const Span& f, double t) const {
    return k_ * t *
           (std::fabs(f.x[1]) +
            t * (std::fabs(f.x[2]) + t * (std::fabs(f.x[3]) + t * std::fabs(f.x[4]))));
  }

  static AlphaBeta stator(double d, double q, const SinCos& a) {
    return {d * a.cos - q * a.sin, d * a.sin + q * a.cos};
  }

 private:
  static constexpr std::array<double, 4> kInverse{0, 1, 0.5, 1.0 / 3};

  // Series from which a span is computed.
  struct Push {
    std::array<double, 4> u_d{}, u_q{}, cog{}, cog_cos{}, harmonic{}, harmonic_cos{};
    std::array<double, 3> stribeck{};  // its force, and the derivatives by v over 1! and 2!
    double inv_r = 0, slope = 0;  // of the Coulomb friction
  };

  double harmonic_angle(double x) const { return 2 * c_.harmonic * k_ * x + 1; }

  // Of the mode on the carriage [N].
  double mode_force(double y, double y_speed) const {
    return c_.mode_stiffness * y + c_.mode_damping * y_speed;
  }

  // By cogging harmonic and cable [N].
  double held_back(double x) const {
    double sum = c_.cable * (x - c_.cable_rest);
    if (c_.harmonic_force != 0) sum += c_.harmonic_force * std::sin(harmonic_angle(x));
    return sum;
  }

  // F = F_s g h with g = exp(-(v/v_s)^2), h = v/sqrt(v^2 + v_f^2).
  void add_stribeck(Push& p, double v) const {
    const double inv_s2 = 1 / (c_.stribeck_speed * c_.stribeck_speed);
    const double g = c_.stribeck * std::exp(-v * v * inv_s2);
    const double g_1 = -2 * v * inv_s2 * g;
    const double g_2 = (4 * v * v * inv_s2 - 2) * inv_s2 * g;
    const double h = v * p.inv_r;
    const double h_2 = -3 * p.slope * v * p.inv_r * p.inv_r;
    p.stribeck = {g * h, g_1 * h + g * p.slope, 0.5 * (g_2 * h + 2 * g_1 * p.slope + g * h_2)};
  }

  // Coefficient n of the product of two series.
  template <std::size_t n>
  static double product(const std::array<double, 4>& a, const std::array<double, 4>& b) {
    double sum = a[0] * b[n];
    if constexpr (n > 0) sum += a[1] * b[n - 1];
    if constexpr (n > 1) sum += a[2] * b[n - 2];
    return sum;
  }

  // Coefficient n + 1 of all series.
  template <std::size_t n>
  void extend(Span& f, Push& p, Hold hold) const {
    constexpr double scale = kInverse[n + 1];
    if (!hold.currents) {
      const double w_iq = k_ * product<n>(f.v, f.i_q);
      const double w_id = k_ * product<n>(f.v, f.i_d);
      f.i_d[n + 1] =
          // Kung eq. 1
          scale * inv_ld_ * (p.u_d[n] - c_.resistance * f.i_d[n] + c_.inductance_q * w_iq);
      // Kung eq. 2
      f.i_q[n + 1] =
          scale * inv_lq_ *
          (p.u_q[n] - c_.resistance * f.i_q[n] - c_.inductance_d * w_id - k_ * lambda_ * f.v[n]);
      p.u_d[n + 1] = scale * k_ * product<n>(f.v, p.u_q);
      p.u_q[n + 1] = -scale * k_ * product<n>(f.v, p.u_d);
    }
    f.x[n + 1] = scale * f.v[n];
    if (!f.elastic) {
      if (!hold.carriage) extend_speed<n>(f, p, 0);
      return;
    }
    const double mode = mode_force(f.y[n], f.y_speed[n]);
    if (!hold.carriage) extend_speed<n>(f, p, mode);
    f.y[n + 1] = scale * f.y_speed[n];
    f.y_speed[n + 1] = -scale * mode / c_.mode_mass - f.v[n + 1];
  }

  template <std::size_t n>
  void extend_speed(Span& f, Push& p, double mode) const {
    constexpr double scale = kInverse[n + 1];
    const double saliency = c_.inductance_d - c_.inductance_q;
    double push = force_ * lambda_ * f.i_q[n] - c_.viscous * f.v[n] + mode;
    if (saliency != 0) push += force_ * saliency * product<n>(f.i_d, f.i_q);
    if constexpr (n == 0) {
      push -= c_.external_force + c_.coulomb * f.v[0] * p.inv_r;
    } else if constexpr (n == 1) {
      push -= c_.coulomb * p.slope * f.v[1];
    } else {
      push -=
          c_.coulomb * p.slope * (f.v[2] - 1.5 * f.v[0] * p.inv_r * p.inv_r * f.v[1] * f.v[1]);
    }
    if (c_.cogging != 0) {
      push -= c_.cogging * p.cog[n];
      p.cog[n + 1] = scale * 2 * k_ * product<n>(f.v, p.cog_cos);
      p.cog_cos[n + 1] = -scale * 2 * k_ * product<n>(f.v, p.cog);
    }
    if (c_.stribeck != 0) {
      push -= n == 0 ? p.stribeck[0] : p.stribeck[1] * f.v[n];
      if constexpr (n == 2) push -= p.stribeck[2] * f.v[1] * f.v[1];
    }
    if (c_.cable != 0) push -= c_.cable * (n == 0 ? f.x[0] - c_.cable_rest : f.x[n]);
    if (c_.harmonic_force != 0) {
      const double rate = scale * 2 * c_.harmonic * k_;
      push -= c_.harmonic_force * p.harmonic[n];
      p.harmonic[n + 1] = rate * product<n>(f.v, p.harmonic_cos);
      p.harmonic_cos[n + 1] = -rate * product<n>(f.v, p.harmonic);
    }
    f.v[n + 1] = scale * inv_mass_ * push;  // Kung eq. 6
  }

  PmlsmConfig c_;
  double k_;  // [rad/m]
  double turns_per_m_, lambda_, force_, inv_ld_, inv_lq_, inv_mass_;
  double saliency_;  // of the inductances, larger over smaller
};

}  // namespace trammel::plant
