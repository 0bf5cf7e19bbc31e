// SPDX-License-Identifier: Apache-2.0
//
// A share of the mass on a spring and a damper, beside the carriage with the encoder.
#include <catch2/catch.hpp>

#include <array>
#include <cmath>

#include "models/plant/axis.hpp"
#include "models/plant/pmlsm.hpp"

using namespace trammel::plant;

namespace {

constexpr double kStep = 6.25e-6;

PmlsmConfig free_pair(double frequency, double damping, double share) {
  PmlsmConfig c;
  c.coulomb = c.viscous = 0;
  c.add_mode(frequency, damping, share);
  return c;
}

MotorState chain(const Pmlsm& m, MotorState s, const AlphaBeta& u, double seconds, Hold hold) {
  const auto spans = static_cast<long>(seconds / kStep + 0.5);
  for (long n = 0; n < spans; ++n) s = m.span(s, m.angle(s.x), u, hold).at(kStep);
  return s;
}

double energy(const PmlsmConfig& c, const MotorState& s) {
  return 0.5 * c.mass * s.v * s.v + 0.5 * c.mode_mass * std::pow(s.v + s.y_speed, 2) +
         0.5 * c.mode_stiffness * s.y * s.y;
}

// The whole axis under a constant voltage, integrated by fine Runge-Kutta steps.
using Y = std::array<double, 6>;  // x, v, i_d, i_q, y, dy/dt

Y slope(const PmlsmConfig& c, const AlphaBeta& u, const Y& s) {
  const double k = kPi / c.pole_pitch, w = k * s[1];
  const double lambda = 2 * c.pole_pitch * c.force_constant / (3 * kPi);
  const double v_d = u.alpha * std::cos(k * s[0]) + u.beta * std::sin(k * s[0]);
  const double v_q = -u.alpha * std::sin(k * s[0]) + u.beta * std::cos(k * s[0]);
  const double spring = c.mode_stiffness * s[4] + c.mode_damping * s[5];
  const double friction = c.coulomb * s[1] / std::hypot(s[1], c.friction_speed);
  const double a = (1.5 * k * lambda * s[3] - c.viscous * s[1] - friction + spring) / c.mass;
  return {s[1],
          a,
          (v_d - c.resistance * s[2] + w * c.inductance_q * s[3]) / c.inductance_d,
          (v_q - c.resistance * s[3] - w * (c.inductance_d * s[2] + lambda)) / c.inductance_q,
          s[5],
          -spring / c.mode_mass - a};
}

Y runge_kutta(const PmlsmConfig& c, const AlphaBeta& u, Y s, double seconds, double h) {
  const auto moved = [](Y a, const Y& b, double by) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += by * b[i];
    return a;
  };
  for (auto n = static_cast<long>(seconds / h + 0.5); n > 0; --n) {
    const Y k1 = slope(c, u, s), k2 = slope(c, u, moved(s, k1, h / 2)),
            k3 = slope(c, u, moved(s, k2, h / 2)), k4 = slope(c, u, moved(s, k3, h));
    for (std::size_t i = 0; i < s.size(); ++i) {
      s[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
  }
  return s;
}

}  // namespace

TEST_CASE("a free pair swings at the frequency and with the damping asked, its centre at rest") {
  for (const double frequency : {15.0, 120.0, 1000.0}) {
    for (const double damping : {0.0, 0.02, 0.3}) {
      for (const double share : {0.01, 0.2, 0.9}) {
        CAPTURE(frequency, damping, share);
        const Pmlsm m(free_pair(frequency, damping, share));
        const double w = 2 * kPi * frequency, swing = w * std::sqrt(1 - damping * damping);
        const double seconds = 0.0625;
        const MotorState s = chain(m, {0, 0, 0, 0, 1e-3, 0}, {}, seconds, {false, true});
        // A series to t^3 leaves (w h)^4 / 24 of the speed in each span.
        const double truncated = std::pow(w * kStep, 3) / 24 * w * seconds;
        const double decay = 1e-3 * std::exp(-damping * w * seconds);
        CHECK(s.y == Approx(decay * (std::cos(swing * seconds) +
                                     damping * w / swing * std::sin(swing * seconds)))
                         .margin(1e-10 + 1e-3 * truncated));
        CHECK(s.x + share * s.y == Approx(share * 1e-3).margin(1e-12));
        CHECK(truncated < 1.1e-3);
      }
    }
  }
}

TEST_CASE("without damping the energy of the pair stays; damping takes from it") {
  PmlsmConfig c = free_pair(80, 0, 0.3);
  const MotorState start{0, 0.1, 0, 0, 2e-3, -0.3};
  CHECK(energy(c, chain(Pmlsm(c), start, {}, 1, {false, true})) ==
        Approx(energy(c, start)).epsilon(1e-6));
  c = free_pair(80, 0.02, 0.3);
  const double centre = c.mass * start.v + c.mode_mass * (start.v + start.y_speed);
  CHECK(energy(c, chain(Pmlsm(c), start, {}, 1, {false, true})) ==
        Approx(0.5 * centre * centre / 2.5).epsilon(1e-4));
}

TEST_CASE("with the carriage held, the rest swings on its spring alone") {
  const PmlsmConfig c = free_pair(50, 0, 0.2);
  const double w = std::sqrt(c.mode_stiffness / c.mode_mass);
  CHECK(w == Approx(2 * kPi * 50 * std::sqrt(0.8)));
  const MotorState s = chain(Pmlsm(c), {0, 0, 0, 0, 1e-3, 0}, {}, 0.03, {true, true});
  CHECK(s.x == 0);
  CHECK(s.y == Approx(1e-3 * std::cos(w * 0.03)).margin(1e-10));
}

TEST_CASE("motor, friction and mode agree with Runge-Kutta") {
  PmlsmConfig c;
  c.inductance_d = c.inductance_q = 20e-3;
  c.friction_speed = 5e-3;
  c.add_mode(150, 0.05, 0.25);
  const AlphaBeta u{30, 20};
  const double seconds = 0.04;
  const MotorState s = chain(Pmlsm(c), {0.1, 0, 0, 0, 1e-4, 0}, u, seconds, {});
  const Y r = runge_kutta(c, u, {0.1, 0, 0, 0, 1e-4, 0}, seconds, kStep / 10);
  CHECK(s.x == Approx(r[0]).epsilon(1e-9));
  CHECK(s.v == Approx(r[1]).margin(1e-8));
  CHECK(s.i_q == Approx(r[3]).margin(1e-7));
  CHECK(s.y == Approx(r[4]).margin(1e-11));
  CHECK(s.y_speed == Approx(r[5]).margin(1e-8));
}

// An axis asks for it to know how long no stop and no edge of the encoder can come.
TEST_CASE("the bound of the acceleration holds what the mode pushes") {
  const PmlsmConfig c = free_pair(200, 0.02, 0.3);
  const Pmlsm m(c);
  for (const double y : {-1e-3, 1e-3}) {
    for (const double y_speed : {-0.5, 0.0, 0.5}) {
      MotorState s{0, 0, 0, 0, y, y_speed};
      const double bound = m.acceleration_bound(s, 0, 4 * kStep);
      for (int n = 0; n < 4; ++n) {
        const double before = s.v;
        s = chain(m, s, {}, kStep, {false, true});
        CAPTURE(y, y_speed, n);
        CHECK(std::abs(s.v - before) / kStep <= bound);
      }
    }
  }
}

TEST_CASE("a carriage that is stopped leaves the rest its speed; without a mode there is none") {
  MotorState s{0, 0.4, 0, 0, 1e-4, -0.1};
  Pmlsm(free_pair(50, 0, 0.2)).halt(s);
  CHECK(s.v == 0);
  CHECK(s.y_speed == Approx(0.3));
  MotorState stiff{0, 0.4, 0, 0, 0, 0};
  Pmlsm(PmlsmConfig{}).halt(stiff);
  CHECK(stiff.y_speed == 0);
}

TEST_CASE("an axis: against a stop the rest swings on and pulls the carriage off again") {
  AxisConfig config;
  config.brake = false;
  config.coulomb_n = config.viscous_n_s_m = 0;
  config.external_force_n = -20;  // towards the upper stop
  config.stroke_max_m = 0.304;
  config.start_m = 0.3;
  config.mode_hz = 30;
  config.mode_mass_ratio = 0.5;
  config.mode_damping = 0;
  Axis axis(config, 20e-9);
  bool stopped = false, came_off = false;
  double largest = 0;
  for (Clk n = 0; n < 10'000'000;) {
    n = axis.next();
    axis.commit(n, 0);
    stopped = stopped || axis.at_stop();
    const AxisState s = axis.state(n);
    came_off = came_off || (stopped && s.v_m_s < -1e-3);
    largest = std::max(largest, s.mode_m);
    REQUIRE(s.x_m <= 0.304 + 1e-9);
  }
  CHECK(stopped);
  CHECK(came_off);
  // What 1.25 kg brought with it at sqrt(2 a x) = 0.25 m/s goes into the spring, which swings.
  const double w = 2 * kPi * 30 * std::sqrt(0.5);
  CHECK(largest == Approx(std::sqrt(2 * 8 * 4e-3) / w).epsilon(0.25));
}
