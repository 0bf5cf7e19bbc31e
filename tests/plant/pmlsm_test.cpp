// SPDX-License-Identifier: Apache-2.0
#include "models/plant/pmlsm.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace trammel::plant;

namespace {

constexpr double kStep = 6.25e-6;

// Against positive motion, apart from the current's [N].
double load(const PmlsmConfig& c, double x, double v) {
  const double friction = v / std::sqrt(v * v + c.friction_speed * c.friction_speed);
  const double stribeck = c.stribeck * std::exp(-std::pow(v / c.stribeck_speed, 2));
  return c.viscous * v + (c.coulomb + stribeck) * friction +
         c.cogging * std::sin(2 * kPi * x / c.pole_pitch) +
         c.harmonic_force * std::sin(2 * kPi * c.harmonic * x / c.pole_pitch + 1) +
         c.cable * (x - c.cable_rest) + c.external_force;
}

// The equations at the head of pmlsm.hpp, written independently and integrated by fine Runge-Kutta
// steps.
struct Reference {
  PmlsmConfig c;
  AlphaBeta u;
  using Y = std::array<double, 4>;  // x, v, i_d, i_q
  Y slope(const Y& y) const {
    const double k = kPi / c.pole_pitch, w = k * y[1], theta = k * y[0];
    const double lambda = 2 * c.pole_pitch * c.force_constant / (3 * kPi);
    const double v_d = u.alpha * std::cos(theta) + u.beta * std::sin(theta);
    const double v_q = -u.alpha * std::sin(theta) + u.beta * std::cos(theta);
    const double force = 1.5 * k * ((c.inductance_d - c.inductance_q) * y[2] + lambda) * y[3];
    return {y[1], (force - load(c, y[0], y[1])) / c.mass,
            (v_d - c.resistance * y[2] + w * c.inductance_q * y[3]) / c.inductance_d,
            (v_q - c.resistance * y[3] - w * c.inductance_d * y[2] - w * lambda) / c.inductance_q};
  }
  static Y add(const Y& a, const Y& b, double h) {
    return {a[0] + h * b[0], a[1] + h * b[1], a[2] + h * b[2], a[3] + h * b[3]};
  }
  void run(Y& y, double t, int steps) const {
    const double h = t / steps;
    for (int n = 0; n < steps; ++n) {
      const Y k1 = slope(y), k2 = slope(add(y, k1, h / 2)), k3 = slope(add(y, k2, h / 2)),
              k4 = slope(add(y, k3, h));
      for (std::size_t i = 0; i < 4; ++i) {
        y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
      }
    }
  }
};

PmlsmConfig odd_motor() {
  PmlsmConfig c;
  c.inductance_d = 18e-3;
  c.cogging = 1;
  c.external_force = 2;
  return c;
}

PmlsmConfig dragged_motor() {
  PmlsmConfig c = odd_motor();
  c.stribeck = 4;
  c.stribeck_speed = 20e-3;
  c.harmonic_force = 3;
  c.harmonic = 5;
  c.cable = 150;
  c.cable_rest = 0.2;
  return c;
}

// A chain of spans under a voltage fixed to the rotor (d, q); visit(span, voltage) sees each.
template <class Visit>
MotorState chain(const Pmlsm& m, MotorState s, double u_d, double u_q, double seconds, Hold hold,
                 Visit visit) {
  const auto spans = static_cast<long>(seconds / kStep + 0.5);
  for (long n = 0; n < spans; ++n) {
    const SinCos a = m.angle(s.x);
    const AlphaBeta u = Pmlsm::stator(u_d, u_q, a);
    const Span f = m.span(s, a, u, hold);
    visit(f, u);
    s = f.at(kStep);
  }
  return s;
}

}  // namespace

// Kung eq. 4, 5
TEST_CASE("the constants derived from K_t are those of the specification") {
  const Pmlsm m{PmlsmConfig{}};
  CHECK(m.flux() == Approx(0.517137).epsilon(2e-6));  // printed digits
  CHECK(m.back_emf_constant() == Approx(53.267).epsilon(2e-5));
  CHECK(m.force({0, 0, 0, 1}) == Approx(79.9).epsilon(1e-12));  // K_t i_q with i_d = 0
  CHECK(m.force({0, 0, 3, 1}) == Approx(79.9).epsilon(1e-12));  // no saliency, no reluctance force
  CHECK(1.5 * m.back_emf_constant() == Approx(79.9).epsilon(1e-12));  // power in = power out
}

TEST_CASE("one electrical period is 61 mm or 12200 counts") {
  const Pmlsm m{PmlsmConfig{}};
  for (int k = 0; k < 50; ++k) {
    const double x = 0.0113 * k;
    CHECK(m.angle(x).sin == Approx(std::sin(kPi * x / 0.0305)).margin(1e-13));
    CHECK(m.angle(x).cos == Approx(std::cos(kPi * x / 0.0305)).margin(1e-13));
    CHECK(m.angle(x + 12200 * 5e-6).sin == Approx(m.angle(x).sin).margin(1e-12));
    CHECK(m.angle(x + 6100 * 5e-6).sin == Approx(-m.angle(x).sin).margin(1e-12));
  }
}

TEST_CASE("the sine without the C library agrees with the library's") {
  for (int k = -4000; k < 4000; ++k) {
    const double turns = k * 0.00137;
    const SinCos a = sin_cos_turns(turns);
    REQUIRE(a.sin == Approx(std::sin(2 * kPi * turns)).margin(2e-14));
    REQUIRE(a.cos == Approx(std::cos(2 * kPi * turns)).margin(2e-14));
    REQUIRE(a.sin * a.sin + a.cos * a.cos == Approx(1).margin(4e-16));
  }
}

// Kung eq. 1, 2, 3, 6
TEST_CASE("a span agrees with fine Runge-Kutta steps of the equations") {
  for (const PmlsmConfig& c : {PmlsmConfig{}, odd_motor(), dragged_motor()}) {
    const Pmlsm m(c);
    for (const double v : {0.0, 2e-4, -0.03, -0.5, 4.0}) {
      const MotorState s{0.123, v, 0.4, -1.7};
      const AlphaBeta u{150, -80};
      const Span f = m.span(s, m.angle(s.x), u, {});
      Reference::Y y{s.x, s.v, s.i_d, s.i_q};
      Reference{c, u}.run(y, kStep, 50);
      const MotorState e = f.at(kStep);
      // Truncation: (R/L h)^4/24 = 1e-10 of the current. At 55 m/s^2 the knee of the friction law
      // (0.5 mm/s) is crossed in 9 us, 1.5 spans: there the speed is good to 1e-7 m/s per newton.
      CHECK(e.i_d == Approx(y[2]).margin(2e-9));
      CHECK(e.i_q == Approx(y[3]).margin(2e-9));
      const double knee = 1e-7 * (c.coulomb + c.stribeck);
      CHECK(e.v == Approx(y[1]).margin(std::fabs(v) < 0.01 ? knee : 2e-9));
      CHECK(e.x == Approx(y[0]).margin(1e-12));
    }
  }
}

TEST_CASE("a standing motor takes V/R with the time constant L/R") {
  const Pmlsm m{PmlsmConfig{}};
  const auto none = [](const Span&, const AlphaBeta&) {};
  // A voltage along d makes no force.
  const MotorState tau = chain(m, {0.1, 0, 0, 0}, 54, 0, 137 * kStep, {}, none);
  // 137 spans, each truncated at (R/L h)^4/24 = 1.2e-10.
  CHECK(tau.i_d == Approx(2 * (1 - std::exp(-27 / 23.3e-3 * 137 * kStep))).epsilon(1.6e-8));
  const MotorState rest = chain(m, {0.1, 0, 0, 0}, 54, 0, 0.03, {}, none);
  CHECK(rest.i_d == Approx(2.0).epsilon(1e-12));
  CHECK(rest.v == 0);
  const MotorState held = chain(m, {0.1, 0, 0, 0}, 0, 54, 0.03, {true, false}, none);
  CHECK(held.i_q == Approx(2.0).epsilon(1e-12));
  CHECK(held.x == 0.1);
}

TEST_CASE("a pushed carriage settles at (F - F_c)/B") {
  PmlsmConfig c;
  c.external_force = -13;
  const Pmlsm m(c);
  const MotorState s = chain(m, {}, 0, 0, 3, {false, true}, [](const Span&, const AlphaBeta&) {});
  CHECK(s.v == Approx((13.0 - 3.0) / 20.0).epsilon(1e-6));  // f(v) = 1 - (v_f/v)^2/2 = 1 - 5e-7
  CHECK(s.i_q == 0);
}

TEST_CASE("a driven carriage settles where voltage and force balance") {
  const Pmlsm m{PmlsmConfig{}};
  const MotorState s = chain(m, {}, 0, 60, 2, {}, [](const Span&, const AlphaBeta&) {});
  const double w = m.angular_speed(s.v);
  CHECK(m.force(s) == Approx(3 + 20 * s.v).epsilon(1e-4));
  CHECK(27 * s.i_q + w * 23.3e-3 * s.i_d + 53.267 * s.v == Approx(60).epsilon(1e-3));
}

TEST_CASE("electrical energy equals loss, work, friction and stored energy") {
  for (const PmlsmConfig& c : {PmlsmConfig{}, odd_motor(), dragged_motor()}) {
    const Pmlsm m(c);
    double in = 0, out = 0;
    const auto power = [&](const Span& f, const AlphaBeta& u, double t) {
      const MotorState s = f.at(t);
      const SinCos a = m.angle_at(f, f.position(t));
      const AlphaBeta i = Pmlsm::stator(s.i_d, s.i_q, a);
      const double out_power =
          1.5 * c.resistance * (s.i_d * s.i_d + s.i_q * s.i_q) + s.v * load(c, s.x, s.v);
      return std::pair{1.5 * (u.alpha * i.alpha + u.beta * i.beta), out_power};
    };
    const auto stored = [&](const MotorState& s) {
      return 0.5 * c.mass * s.v * s.v +
             0.75 * (c.inductance_d * s.i_d * s.i_d + c.inductance_q * s.i_q * s.i_q);
    };
    const MotorState end =
        chain(m, {0.1, 0, 0, 0}, 10, 70, 0.15, {}, [&](const Span& f, const AlphaBeta& u) {
          const auto a = power(f, u, 0), b = power(f, u, kStep / 2), e = power(f, u, kStep);
          in += kStep / 6 * (a.first + 4 * b.first + e.first);
          out += kStep / 6 * (a.second + 4 * b.second + e.second);
        });
    CHECK(in > 8);
    CHECK(end.v > 0.3);
    CHECK(in == Approx(out + stored(end)).epsilon(1e-8));  // Simpson and truncation errors
  }
}

// dv/dt = -a sin(k x), a = F_cog / M, k = 2 pi / tau. Its derivatives: -a k cos(k x) v, and
// a k (k sin(k x) v^2 - cos(k x) dv/dt).
TEST_CASE("pmlsm: the series of the speed has the cogging force up to the third order") {
  PmlsmConfig c;
  c.cogging = 40;
  c.coulomb = c.viscous = 0;
  const Pmlsm motor(c);
  for (const double x : {0.001, 0.006, 0.011, 0.02}) {
    CAPTURE(x);
    const double v = 0.7, a = c.cogging / c.mass, k = 2 * kPi / c.pole_pitch;
    const double sin = std::sin(k * x), cos = std::cos(k * x);
    const Span span = motor.span({x, v, 0, 0}, motor.angle(x), {0, 0}, {false, true});
    CHECK(span.v[1] == Approx(-a * sin));
    CHECK(span.v[2] == Approx(-a * k * cos * v / 2));
    CHECK(span.v[3] == Approx(a * k * (k * sin * v * v + cos * a * sin) / 6));
  }
}

TEST_CASE("a cable pulls the carriage to its place of rest, and friction holds most at rest") {
  PmlsmConfig c;
  c.coulomb = 0;
  c.cable = 40;
  c.cable_rest = 0.25;
  const auto none = [](const Span&, const AlphaBeta&) {};
  const MotorState rest = chain(Pmlsm(c), {0.2, 0, 0, 0}, 0, 0, 4, {false, true}, none);
  CHECK(rest.x == Approx(0.25).margin(1e-6));

  // 4 N are above the 3 N of moving friction and below the 5 N at rest: a carriage at rest stays,
  // but for the creep of the smooth law; one that moves settles at (4 - 3) N / B.
  c = PmlsmConfig();
  c.stribeck = 2;
  c.external_force = -4;
  CHECK(chain(Pmlsm(c), {}, 0, 0, 1, {false, true}, none).v < 1e-3);
  CHECK(chain(Pmlsm(c), {0, 0.2, 0, 0}, 0, 0, 3, {false, true}, none).v ==
        Approx(1.0 / 20).epsilon(1e-3));
}

TEST_CASE("no acceleration is above its bound, of salient motors and fine pole pitches too") {
  std::mt19937 random(11);
  const auto any = [&random](double from, double to) {
    return from * std::pow(to / from, std::uniform_real_distribution<>()(random));
  };
  constexpr double kVolt = 100, kTime = 62.5e-6, kFine = 50e-9;
  double closest = 0;
  for (int trial = 0; trial < 500; ++trial) {
    PmlsmConfig c;
    c.resistance = any(0.01, 10);
    c.inductance_d = any(1e-4, 0.1);
    c.inductance_q = any(1e-4, 0.1);
    c.pole_pitch = any(1e-4, 0.1);
    c.force_constant = any(1, 100);
    c.mass = any(1, 100);
    c.cogging = any(0.1, 10);
    const Pmlsm motor(c);
    const auto sign = [&random] { return random() % 2 == 0 ? 1.0 : -1.0; };
    const MotorState begin{any(0.1, 1), sign() * any(0.01, 1), sign() * any(0.01, 10),
                           sign() * any(0.01, 10), 0, 0};
    const double bound = motor.acceleration_bound(begin, kVolt, kTime);
    const double turn = any(0.1, 6);
    const AlphaBeta u{2.0 / 3 * kVolt * std::cos(turn), 2.0 / 3 * kVolt * std::sin(turn)};
    MotorState s = begin;
    for (double t = 0; t < kTime && std::fabs(s.v - begin.v) < 0.1; t += kFine) {
      const Span span = motor.span(s, motor.angle(s.x), u, {});
      closest = std::max(closest, std::fabs(span.v[1]) / bound);
      s = span.at(kFine);
    }
  }
  CHECK(closest < 1);
  CHECK(closest > 0.3);
}

// The equations differentiated along their own course, by differences.
TEST_CASE("pmlsm: each series has the derivatives of the equations up to the third order") {
  const std::array<const char*, 4> name{"x", "v", "i_d", "i_q"};
  PmlsmConfig slow = dragged_motor();  // whose frictions turn over where the carriage moves
  slow.friction_speed = 30e-3;
  slow.stribeck_speed = 50e-3;
  slow.coulomb = 6;
  PmlsmConfig odd = odd_motor();
  odd.friction_speed = 10e-3;
  for (const PmlsmConfig& c : {odd, slow}) {
    const Pmlsm motor(c);
    std::mt19937 random(3);
    for (int trial = 0; trial < 40; ++trial) {
      const auto any = [&random](double most) {
        return std::uniform_real_distribution<>(-most, most)(random);
      };
      const Reference::Y y{any(0.2), any(0.1), any(2), any(2)};
      const Reference reference{c, {any(60), any(60)}};
      constexpr double h = 2e-6;
      const auto along = [&reference](auto f, const Reference::Y& at) {
        const Reference::Y slope = reference.slope(at);
        const auto up = f(Reference::add(at, slope, h)), down = f(Reference::add(at, slope, -h));
        Reference::Y d{};
        for (std::size_t k = 0; k < 4; ++k) d[k] = (up[k] - down[k]) / (2 * h);
        return d;
      };
      const auto first = [&](const Reference::Y& at) { return reference.slope(at); };
      const auto second = [&](const Reference::Y& at) { return along(first, at); };
      const std::array<Reference::Y, 3> exact{first(y), second(y), along(second, y)};
      const SinCos a = motor.angle(y[0]);
      const Span f = motor.span({y[0], y[1], y[2], y[3]}, a, reference.u, {});
      for (std::size_t n = 1; n < 4; ++n) {
        const double factorial = n == 3 ? 6 : static_cast<double>(n);
        const std::array<double, 4> series{f.x[n], f.v[n], f.i_d[n], f.i_q[n]};
        for (std::size_t k = 0; k < 4; ++k) {
          INFO("order " << n << " of " << name[k] << " at x " << y[0] << ", v " << y[1]);
          // A coefficient may pass 0: 1e-3 of what its terms are.
          const double scale = std::pow(3000.0, static_cast<double>(n)) / factorial;
          CHECK(series[k] == Approx(exact[n - 1][k] / factorial).epsilon(1e-3).margin(
                                 1e-4 * scale * (k == 0 ? 1e-3 : k == 1 ? 0.01 : 1)));
        }
      }
      // And the slope of the currents in the stator's frame, which a floating leg goes by.
      const auto stator = [&](double ahead) {
        const Reference::Y at = Reference::add(y, reference.slope(y), ahead);
        const AlphaBeta i = Pmlsm::stator(at[2], at[3], motor.angle(at[0]));
        return std::array<double, 2>{i.alpha, i.beta};
      };
      const auto after = stator(1e-7), before = stator(-1e-7);
      const AlphaBeta slope = motor.current_slope({y[0], y[1], y[2], y[3]}, a, reference.u);
      CHECK(slope.alpha == Approx((after[0] - before[0]) / 2e-7).epsilon(1e-4).margin(0.05));
      CHECK(slope.beta == Approx((after[1] - before[1]) / 2e-7).epsilon(1e-4).margin(0.05));
      // Without current the back-EMF is the voltage that lets none begin.
      const MotorState bare{y[0], y[1], 0, 0};
      const AlphaBeta still = motor.current_slope(bare, a, motor.emf(bare, a));
      CHECK(still.alpha == Approx(0).margin(1e-6));
      CHECK(still.beta == Approx(0).margin(1e-6));
      // Of a volt more along a direction, along it.
      const double angle = any(3), n_a = std::cos(angle), n_b = std::sin(angle);
      const MotorState s{y[0], y[1], y[2], y[3]};
      const AlphaBeta more = motor.current_slope(
          s, a, {reference.u.alpha + n_a, reference.u.beta + n_b});
      CHECK(motor.slope_per_volt(a, {n_a, n_b}) ==
            Approx((more.alpha - slope.alpha) * n_a + (more.beta - slope.beta) * n_b));
    }
  }
}
