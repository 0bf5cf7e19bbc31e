// SPDX-License-Identifier: Apache-2.0
//
// The belt axis away from its defaults: each step of each mass against the equations of its header,
// in physical terms, and closed forms of the winding and of what is seen.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "models/plant/belt_axis.hpp"

using namespace trammel;
using plant::BeltAxis;
using plant::BeltAxisConfig;
using plant::BeltState;

namespace {

constexpr double kStepS = 5e-6;  // [s]

BeltAxisConfig own() {
  BeltAxisConfig c;
  c.motor_mass = 0.3;
  c.cart_mass = 1.3;
  c.count_force = 0.02;
  c.full_counts = 700;
  c.coulomb = 50;
  c.stiction = 90;
  c.cart_share = 0.4;
  c.viscous = 11;
  c.belt_stiffness = 3e4;
  c.belt_damping = 0.35;
  c.gap = 4e-5;
  c.stop_low = -1e-3;
  c.stop_high = 6e-3;
  c.stop_stiffness = 2e5;
  c.stop_damping = 0.3;
  c.zones = {{{1e-3, 1.5e-3}, {3e-3, 3.5e-3}}};
  c.zone_more = 0.6;
  c.zone_ramp = 0.4e-3;
  c.winding = 0.2e-3;
  return c;
}

// [N] of a spring of that stiffness and share of critical damping between two bodies, the reduced
// mass of which is `mass`: bent by `x` at the rate `v`, and it pushes only.
double spring(double stiffness, double ratio, double mass, double x, double v) {
  if (x == 0) return 0;
  const double force = stiffness * x + 2 * ratio * std::sqrt(stiffness * mass) * v;
  return x * force > 0 ? force : 0;
}

double bent(double apart, double gap) {
  return apart > gap ? apart - gap : apart < -gap ? apart + gap : 0;
}

// What friction leaves of a speed: `slides` and `sticks` [N].
double rubbed(double v, double force, double slides, double sticks, double mass) {
  if (v == 0 && std::fabs(force) <= sticks) return 0;
  const double against = std::copysign(slides, v == 0 ? force : v);
  const double next = v + kStepS * (force - against) / mass;
  return next * v < 0 ? 0 : next;
}

std::array<double, 3> speeds(const BeltAxisConfig& c, const BeltState& s,
                             const std::array<double, 2>& counts) {
  const double pair = 1 / (1 / c.motor_mass + 1 / c.cart_mass);
  const auto belt = [&](std::size_t motor) {
    return spring(c.belt_stiffness, c.belt_damping, pair, bent(s.x[motor] - s.x[1], c.gap),
                  s.v[motor] - s.v[1]);
  };
  const double one = belt(0), two = belt(2);
  const double past = std::min(s.x[1] - c.stop_low, 0.0) + std::max(s.x[1] - c.stop_high, 0.0);
  const double stop = -spring(c.stop_stiffness, c.stop_damping, c.cart_mass, past, s.v[1]);
  double more = 0;
  for (const plant::FrictionZone& zone : c.zones) {
    const double outside = std::max({zone.from - s.x[1], s.x[1] - zone.to, 0.0});
    more = std::max(more, 1 - outside / c.zone_ramp);
  }
  const double count = c.count_force * (1 + c.zone_more * more);
  const std::array<double, 3> force{c.count_force * counts[0] / 2 - c.viscous * s.v[0] - one,
                                    one + two + stop,
                                    c.count_force * counts[1] / 2 - c.viscous * s.v[2] - two};
  const std::array<double, 3> mass{c.motor_mass, c.cart_mass, c.motor_mass};
  const std::array<double, 3> share{(1 - c.cart_share) / 2, c.cart_share, (1 - c.cart_share) / 2};
  std::array<double, 3> v{};
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] = rubbed(s.v[k], force[k], share[k] * count * c.coulomb, share[k] * count * c.stiction,
                  mass[k]);
  }
  return v;
}

}  // namespace

TEST_CASE("belt axis: each mass obeys its equation in each step, in zones and at both stops") {
  const BeltAxisConfig c = own();
  BeltAxis axis(c);
  axis.drive(0, {0, 0});
  bool low = false, high = false, zone = false, apart = false;
  for (int k = 1; k <= 60'000; ++k) {
    // To and fro, 100 ms each, the motors of unlike duty, at times against each other.
    const double way = k / 20'000 % 2 == 0 ? 1 : -1;
    const std::array<double, 2> bridge{way, k % 1700 < 300 ? -way : k % 3 == 0 ? 0 : way};
    const BeltState before = axis.state();
    axis.drive(k * BeltAxis::kStep, bridge);
    const BeltState after = axis.state();
    const std::array<double, 3> wanted = speeds(c, before, after.force);
    for (std::size_t mass = 0; mass < 3; ++mass) {
      if (after.v[mass] == Approx(wanted[mass]).epsilon(1e-9).margin(1e-12)) continue;
      CAPTURE(k, mass, before.x, before.v, after.force);
      REQUIRE(after.v[mass] == Approx(wanted[mass]).epsilon(1e-9).margin(1e-12));
    }
    for (std::size_t mass = 0; mass < 3; ++mass) {
      REQUIRE(after.x[mass] == Approx(before.x[mass] + kStepS * after.v[mass]).margin(1e-15));
    }
    for (const std::size_t motor : {BeltState::kMotor1, BeltState::kMotor2}) {
      const double b = bent(after.x[motor] - after.x[1], c.gap);
      REQUIRE(axis.flank(motor) == (b > 0) - (b < 0));
    }
    low = low || after.x[1] < c.stop_low;
    high = high || after.x[1] > c.stop_high;
    zone = zone || (after.x[1] > 1e-3 && after.x[1] < 1.5e-3);
    apart = apart || (axis.flank(BeltState::kMotor1) == 0 && after.v[1] != 0);
  }
  CHECK((low && high && zone && apart));
}

TEST_CASE("belt axis: the force of a winding comes with its time constant, of each motor alone") {
  for (const double winding : {8e-6, 40e-6, 0.5e-3}) {
    BeltAxisConfig c = own();
    c.winding = winding;
    BeltAxis axis(c);
    axis.drive(0, {1, -0.5});
    for (int k = 1; k <= 20; ++k) {
      axis.drive(k * BeltAxis::kStep, {1, -0.5});
      const double there = 1 - std::exp(-k * kStepS / winding);
      CAPTURE(winding, k);
      CHECK(axis.state().force[0] == Approx(700 * there));
      CHECK(axis.state().force[1] == Approx(-350 * there));
    }
  }
}

TEST_CASE("belt axis: a bridge acts from its clock on, by its share of the step") {
  BeltAxisConfig c = own();
  c.winding = 0;
  for (const std::int64_t at : {0, 1, 100, 249}) {
    BeltAxis axis(c);
    axis.drive(at, {1, 0});
    axis.drive(BeltAxis::kStep, {0, 1});
    CAPTURE(at);
    CHECK(axis.state().force[0] == Approx(700 * static_cast<double>(250 - at) / 250));
    CHECK(axis.state().force[1] == 0);
    axis.drive(2 * BeltAxis::kStep, {0, 0});
    CHECK(axis.state().force[0] == 0);
    CHECK(axis.state().force[1] == 700);
  }
}

TEST_CASE("belt axis: what is seen behind the last step is what comes if nothing changes") {
  for (const double delay : {0.0, 1e-3}) {
    BeltAxisConfig c = own();
    c.delay = delay;
    BeltAxis axis(c);
    axis.drive(0, {1, 1});
    axis.drive(400'000, {1, 1});  // 8 ms
    for (const std::int64_t more : {0, 60, 250, 251, 900, 60'000}) {
      const BeltAxis::Seen early = axis.seen(400'000 + more);
      BeltAxis later = axis;
      later.drive(400'000 + more + 5 * BeltAxis::kStep, {1, 1});
      const BeltAxis::Seen late = later.seen(400'000 + more);
      CAPTURE(delay, more);
      CHECK(early.x == late.x);
      CHECK(early.v == late.v);
      CHECK(early.v > 0);
    }
  }
}
