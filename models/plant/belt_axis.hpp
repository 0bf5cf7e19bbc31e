// SPDX-License-Identifier: Apache-2.0
//
// A cart on a toothed belt with a geared motor at each end; three masses on a line:
//   m dv/dt = F - c v - friction(F, v) + contact
// The belt and the backlash of a gear wheel make the contact: a spring and damper behind a dead
// zone, which pushes and never pulls. Friction is Coulomb's with stiction, larger in zones; a speed
// that would change its sign within a step is 0. Each motor's force follows its bridge with the
// electrical time constant of its winding. Semi-implicit Euler steps of 5 us; a bridge that
// switches inside a step acts by its share of it. What is seen of the cart is `delay` old.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace trammel::plant {

struct FrictionZone {
  double from = 0, to = 0;  // [m] of the cart
};

// One force count of both motors is g/tau of 1.5 kg: 0.511 mm/s and 40 ms, from the thesis' runs.
struct BeltAxisConfig {
  std::int64_t clock_ps = 20'000;
  double motor_mass = 0.5, cart_mass = 0.5;       // [kg] each
  double count_force = 0.511e-3 / 0.04 * 1.5;     // [N] a count of the mean of both motors
  double full_counts = 1023;                      // [count] of a bridge that is on
  double coulomb = 88, stiction = 94;             // [count] in all
  double cart_share = 0.5;                        // of friction; the motors share the rest
  double viscous = 18.75;                         // [N s/m] of each motor
  double belt_stiffness = 2e4, belt_damping = 0.2;   // [N/m], ratio
  double gap = 0;                                 // [m] half of the backlash, each wheel
  double stop_low = -2e-3, stop_high = 0.472;     // [m]
  double stop_stiffness = 1e5, stop_damping = 0.2;   // [N/m], ratio
  std::array<FrictionZone, 2> zones{{{0.090, 0.110}, {0.220, 0.290}}};
  double zone_more = 0.25, zone_ramp = 5e-3;      // share, [m]
  std::array<double, 2> left{1, 1}, right{1, 1};  // share of its force a motor has, by its sense
  double winding = 0.5e-3;                        // [s]; 0: the force is the bridge's at once
  double delay = 9.5e-3;                          // [s]
  double start = 0;                               // [m]
};

struct BeltState {
  static constexpr std::size_t kMotor1 = 0, kCart = 1, kMotor2 = 2;
  std::array<double, 3> x{}, v{};      // [m], [m/s]
  std::array<double, 2> force{};       // [count], positive: the position increases
};

class BeltAxis {
 public:
  using Clk = std::int64_t;
  static constexpr Clk kStep = 250;  // [clk], 5 us

  explicit BeltAxis(const BeltAxisConfig& config) : c_(config) {
    s_.x.fill(c_.start);
    const double seconds = 1e-12 * static_cast<double>(c_.clock_ps);
    h_ = kStep * seconds;
    follow_ = c_.winding > 0 ? 1 - std::exp(-h_ / c_.winding) : 1;
    mass_ = {c_.motor_mass, c_.cart_mass, c_.motor_mass};
    const double pair = c_.motor_mass * c_.cart_mass / (c_.motor_mass + c_.cart_mass);
    belt_loss_ = 2 * c_.belt_damping * std::sqrt(c_.belt_stiffness * pair);
    stop_loss_ = 2 * c_.stop_damping * std::sqrt(c_.stop_stiffness * c_.cart_mass);
    const auto late = static_cast<Clk>(std::llround(c_.delay / seconds));
    late_ = late;
    past_.resize(static_cast<std::size_t>(late / kStep + kSpare), {c_.start, 0});
  }

  const BeltAxisConfig& config() const { return c_; }
  const BeltState& state() const { return s_; }  // at the last whole step
  Clk at() const { return at_; }

  // To edge n with the bridges as they were; from there on with these: -1, 0 or 1 of the supply,
  // positive where the position increases.
  void drive(Clk n, const std::array<double, 2>& bridge) {
    advance(n);
    bridge_ = bridge;
  }
  void open(std::size_t motor, bool open) { alive_[motor] = open ? 0 : 1; }
  void supply(double share) { supply_ = share; }

  // The axis at edge n, which is no earlier than the last one that was passed; the bridges stay.
  BeltAxis ahead(Clk n) const {
    BeltAxis axis = *this;
    axis.advance(n);
    return axis;
  }
  double cart(Clk n) const { return ahead(n).s_.x[BeltState::kCart]; }  // [m]

  struct Seen {
    double x = 0, v = 0;  // [m], [m/s] of the cart
  };

  // What a sensor tells at edge n, which is no earlier than the last one that was passed.
  Seen seen(Clk n) const {
    const Clk then = n - late_;
    if (then <= 0) return {c_.start, 0};
    const Clk following = (then / kStep + 1) * kStep;
    return following > steps_ * kStep ? ahead(following).seen_at(then) : seen_at(then);
  }

  // Mean of a motor's force [count] over the clocks before the last whole step, 310 us at most.
  // Over a period of its bridge it has no ripple.
  double mean_force(std::size_t motor, Clk over) const {
    const double end = static_cast<double>(steps_);
    const double begin = std::max(0.0, end - static_cast<double>(over) / kStep);
    if (begin == end) return 0;
    const double whole = std::floor(begin);
    const auto at = [&](double step) {
      return sums_[static_cast<std::size_t>(step) % sums_.size()][motor];
    };
    const double before = at(whole) + (begin - whole) * (at(whole + 1) - at(whole));
    return (at(end) - before) / (end - begin);
  }

  // Kinetic and elastic energy [J].
  double energy() const {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += 0.5 * mass_[k] * s_.v[k] * s_.v[k];
    for (const std::size_t motor : {BeltState::kMotor1, BeltState::kMotor2}) {
      const double bent = bend(motor);
      sum += 0.5 * c_.belt_stiffness * bent * bent;
    }
    return sum;
  }

  // -1, 0, 1: the flank of a motor's wheel that pushes the cart.
  int flank(std::size_t motor) const {
    const double bent = bend(motor);
    return bent > 0 ? 1 : bent < 0 ? -1 : 0;
  }

 private:
  static constexpr Clk kSpare = 512;  // steps that may be passed before a question

  double bend(std::size_t motor) const {
    const double apart = s_.x[motor] - s_.x[BeltState::kCart];
    return apart > c_.gap ? apart - c_.gap : apart < -c_.gap ? apart + c_.gap : 0;
  }

  double contact(std::size_t motor) const {  // [N] on the cart
    const double bent = bend(motor);
    if (bent == 0) return 0;
    const double loss = belt_loss_ * (s_.v[motor] - s_.v[BeltState::kCart]);
    const double force = c_.belt_stiffness * bent + loss;
    return bent > 0 ? std::max(0.0, force) : std::min(0.0, force);
  }

  double stop() const {  // [N] on the cart
    const double x = s_.x[BeltState::kCart], v = s_.v[BeltState::kCart];
    if (x < c_.stop_low) {
      return std::max(0.0, c_.stop_stiffness * (c_.stop_low - x) - stop_loss_ * v);
    }
    if (x > c_.stop_high) {
      return std::min(0.0, c_.stop_stiffness * (c_.stop_high - x) - stop_loss_ * v);
    }
    return 0;
  }

  double roughness() const {
    const double x = s_.x[BeltState::kCart];
    double most = 0;
    for (const FrictionZone& zone : c_.zones) {
      const double inside = std::min(x - zone.from, zone.to - x) + c_.zone_ramp;
      most = std::max(most, std::clamp(inside / c_.zone_ramp, 0.0, 1.0));
    }
    return 1 + c_.zone_more * most;
  }

  void advance(Clk n) {
    while (at_ < n) {
      const Clk end = (steps_ + 1) * kStep, to = std::min(n, end);
      for (std::size_t m = 0; m < 2; ++m) on_[m] += bridge_[m] * static_cast<double>(to - at_);
      at_ = to;
      if (to == end) step();
    }
  }

  void step() {
    for (std::size_t m = 0; m < 2; ++m) {
      const double share = on_[m] > 0 ? c_.left[m] : c_.right[m];
      const double asked = alive_[m] * supply_ * share * c_.full_counts * on_[m] / kStep;
      s_.force[m] += follow_ * (asked - s_.force[m]);
      on_[m] = 0;
    }
    const double one = contact(BeltState::kMotor1), two = contact(BeltState::kMotor2);
    const double half = 0.5 * c_.count_force;
    const std::array<double, 3> forces{
        half * s_.force[0] - c_.viscous * s_.v[0] - one, one + two + stop(),
        half * s_.force[1] - c_.viscous * s_.v[2] - two};
    const double rough = c_.count_force * roughness(), motor = 0.5 * (1 - c_.cart_share);
    const std::array<double, 3> shares{motor, c_.cart_share, motor};
    for (std::size_t k = 0; k < 3; ++k) {
      const double rub = shares[k] * rough;
      s_.v[k] = next_speed(s_.v[k], forces[k], rub * c_.coulomb, rub * c_.stiction, mass_[k]);
      s_.x[k] += h_ * s_.v[k];
    }
    std::array<double, 2>& sum = sums_[static_cast<std::size_t>(steps_ + 1) % sums_.size()];
    sum = sums_[static_cast<std::size_t>(steps_) % sums_.size()];
    for (std::size_t m = 0; m < 2; ++m) sum[m] += s_.force[m];
    ++steps_;
    past_[static_cast<std::size_t>(steps_) % past_.size()] = {s_.x[BeltState::kCart],
                                                              s_.v[BeltState::kCart]};
  }

  double next_speed(double v, double force, double coulomb, double stiction, double mass) const {
    if (v == 0) {
      if (std::fabs(force) <= stiction) return 0;
      return h_ * (force - std::copysign(coulomb, force)) / mass;
    }
    const double next = v + h_ * (force - std::copysign(coulomb, v)) / mass;
    return next * v < 0 ? 0 : next;
  }

  Seen seen_at(Clk then) const {
    const Clk step = then / kStep;
    const double share = static_cast<double>(then % kStep) / kStep;
    const Seen& a = past_[static_cast<std::size_t>(step) % past_.size()];
    const Seen& b = past_[static_cast<std::size_t>(step + 1) % past_.size()];
    return {a.x + share * (b.x - a.x), a.v + share * (b.v - a.v)};
  }

  BeltAxisConfig c_;
  BeltState s_;
  std::array<double, 3> mass_{};
  std::array<double, 2> bridge_{}, on_{}, alive_{1, 1};
  double supply_ = 1, h_ = 0, follow_ = 1, belt_loss_ = 0, stop_loss_ = 0;
  Clk at_ = 0, steps_ = 0, late_ = 0;
  std::vector<Seen> past_;  // by step, the last ones
  std::array<std::array<double, 2>, 64> sums_{};  // of the forces, by step, the last ones
};

}  // namespace trammel::plant
