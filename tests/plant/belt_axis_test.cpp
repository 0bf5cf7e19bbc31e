// SPDX-License-Identifier: Apache-2.0
//
// Cart, belt and motors against closed forms, their energy, and themselves at other steps; single
// parts: ramps of friction, contacts, ends, an open motor, errors of B.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

#include "models/plant/belt_axis.hpp"
#include "models/plant/stripe_track.hpp"

using namespace trammel;
using plant::BeltAxis;
using plant::BeltAxisConfig;
using plant::BeltState;

namespace {

constexpr std::int64_t kSecond = 50'000'000;  // [clk]

BeltAxisConfig smooth() {
  BeltAxisConfig c;
  c.zone_more = 0;
  c.winding = 0;
  return c;
}

// A bridge of 7.2 kHz at a duty, for so long from where the axis is.
void push(BeltAxis& axis, double duty, double seconds) {
  constexpr std::int64_t kPeriod = 6938;
  const std::int64_t begin = axis.at(), end = begin + std::llround(seconds * kSecond);
  const double sign = duty < 0 ? -1 : 1;
  const auto on = std::llround(std::fabs(duty) * kPeriod);
  for (std::int64_t t = begin; t < end; t += kPeriod) {
    axis.drive(t, {sign, sign});
    axis.drive(t + on, {0, 0});
  }
  axis.drive(end, {0, 0});
}

BeltAxisConfig frictionless() {
  BeltAxisConfig c;
  c.zone_more = c.winding = c.coulomb = c.stiction = c.viscous = 0;
  return c;
}

}  // namespace

TEST_CASE("belt axis: the speed rises to 0.511 mm/s a count beyond friction, with 40 ms") {
  BeltAxisConfig c = smooth();
  BeltAxis axis(c);
  axis.drive(0, {1, 1});  // 1023 counts
  const double last = 0.511e-3 * (1023 - 88);
  for (const double t : {0.02, 0.04, 0.1, 0.4}) {
    axis.drive(std::llround(t * kSecond), {1, 1});
    // The belt between the masses gives a mode of 45 Hz, of which a trace is left.
    CHECK(axis.state().v[BeltState::kCart] ==
          Approx(last * (1 - std::exp(-t / 0.04))).margin(0.02 * last));
  }
  CHECK(axis.state().v[BeltState::kCart] == Approx(last).epsilon(1e-3));
}

// A motor breaks away first, bends the belt, and adds its force less its Coulomb friction to the
// cart: slowly pushed, the whole goes between 88 and 94 counts.
TEST_CASE("belt axis: up to 88 counts leave it at rest, 96 do not, and 25 % more in a zone") {
  for (const double share : {88.0 / 88, 96.0 / 88}) {
    for (const bool zone : {false, true}) {
      BeltAxisConfig c;
      c.winding = 5e-3;  // the ripple of the bridge is then below a count
      c.start = zone ? 0.1 : 0.15;
      BeltAxis axis(c);
      const double counts = share * (zone ? 110 : 88);
      for (int k = 1; k <= 100; ++k) push(axis, counts / 1023 * k / 100, 0.01);
      push(axis, counts / 1023, 0.5);
      const double moved = std::fabs(axis.state().x[BeltState::kCart] - c.start);
      CAPTURE(counts);
      if (share == 1) CHECK(moved == 0);
      if (share > 1) CHECK(moved > 1e-4);
    }
  }
}

TEST_CASE("belt axis: without force its energy falls in every step, and it comes to rest") {
  for (const double gap : {0.0, 1.5e-4}) {
    BeltAxisConfig c = smooth();
    c.gap = gap;
    BeltAxis axis(c);
    push(axis, 0.9, 0.2);
    double energy = axis.energy();
    const double first = energy;
    for (int k = 0; k < 4000; ++k) {
      axis.drive(axis.at() + 5 * BeltAxis::kStep, {0, 0});
      // A step of 5 us errs by the belt's frequency times it: 0.2 % of what is bent.
      CHECK(axis.energy() <= energy + 1e-5 * first);
      energy = axis.energy();
    }
    CHECK(axis.state().v[BeltState::kCart] == 0);
  }
}

TEST_CASE("belt axis: a motor that meets no cart comes to the speed of its own friction") {
  for (const std::size_t motor : {0, 1}) {
    BeltAxisConfig c = smooth();
    c.gap = 100;
    BeltAxis axis(c);
    axis.drive(0, {motor == 0 ? 1.0 : 0.0, motor == 1 ? 1.0 : 0.0});
    axis.drive(kSecond, {0, 0});
    const double counts = 0.5 * c.full_counts - 0.25 * c.coulomb;  // its force less its friction
    const std::array<std::size_t, 2> wheel{BeltState::kMotor1, BeltState::kMotor2};
    CAPTURE(motor);
    CHECK(axis.state().v[wheel[motor]] ==
          Approx(c.count_force * counts / c.viscous).epsilon(1e-6));
    CHECK(axis.state().v[wheel[1 - motor]] == 0);
    CHECK(axis.state().v[BeltState::kCart] == 0);
  }
}

TEST_CASE("belt axis: a stop holds the cart, which bounces less than it came") {
  BeltAxisConfig c = smooth();
  c.start = 0.4;
  BeltAxis axis(c);
  axis.drive(0, {1, 1});
  double farthest = 0;
  for (int k = 0; k < 2000; ++k) {
    axis.drive(axis.at() + 100 * BeltAxis::kStep, {1, 1});
    farthest = std::max(farthest, axis.state().x[BeltState::kCart]);
  }
  CHECK(farthest < c.stop_high + 5e-3);
  CHECK(axis.state().x[BeltState::kCart] ==
        Approx(c.stop_high + c.count_force * 1023 / c.stop_stiffness).margin(5e-5));
}

TEST_CASE("belt axis: with backlash a motor that turns back leaves the cart for twice the gap") {
  BeltAxisConfig c = smooth();
  c.gap = 1.5e-4;
  BeltAxis axis(c);
  push(axis, 0.3, 0.3);
  push(axis, 0, 0.3);
  const double cart = axis.state().x[BeltState::kCart];
  const double wheel = axis.state().x[BeltState::kMotor1];
  CHECK(axis.flank(BeltState::kMotor1) >= 0);
  double free_way = 0;
  axis.drive(axis.at(), {-0.2, -0.2});
  for (int k = 0; k < 20000 && std::fabs(axis.state().x[BeltState::kCart] - cart) < 1e-6; ++k) {
    axis.drive(axis.at() + BeltAxis::kStep, {-0.2, -0.2});
    free_way = wheel - axis.state().x[BeltState::kMotor1];
  }
  CHECK(free_way > 1e-4);
  CHECK(free_way < 3.6e-4);
}

TEST_CASE("belt axis: what is seen is the cart of its delay ago, whenever it is asked") {
  BeltAxisConfig c;
  BeltAxis axis(c);
  const std::int64_t asked = 5'000'000;
  axis.drive(0, {1, 1});
  axis.drive(asked - std::llround(c.delay / 2e-8), {1, 1});
  const double then = axis.state().x[BeltState::kCart];
  const double early = axis.seen(asked).x;
  axis.drive(asked, {1, 1});
  CHECK(axis.seen(asked).x == early);
  CHECK(early == Approx(then).margin(1e-12));
  c.delay = 0;
  BeltAxis prompt(c);
  prompt.drive(0, {1, 1});
  prompt.drive(3'000'000, {1, 1});
  const double ahead = prompt.seen(3'040'000).x;
  prompt.drive(3'040'000, {1, 1});
  CHECK(ahead == prompt.state().x[BeltState::kCart]);
}

TEST_CASE("stripe track: derivatives are 500 codes at 500 mm/s, and a defect shifts the stripes") {
  const plant::StripeTrack track{plant::StripeTrackConfig{}};
  CHECK(track.code(3, 0.005, 0.5) == 1012);
  CHECK(track.code(1, 0.00625, 0.5) == 12);
  CHECK(track.code(0, 0.005, 0) == 912);
  CHECK(track.code(2, 0.00625, 0) == 912);
  CHECK(track.seen(0.190) - 0.190 == Approx(200 * 5e-3 / 16384));
  CHECK(track.seen(0.300) - 0.300 == Approx(-200 * 5e-3 / 16384));
  CHECK(track.seen(0.2) == 0.2);
}

TEST_CASE("belt axis: in the middle of a zone's ramp half of its friction is added") {
  for (const double at : {0.0875, 0.1125, 0.2175, 0.2925}) {
    for (const double counts : {98.0, 108.0}) {  // no zone: 88 to 94
      BeltAxisConfig c;
      c.winding = 0;
      c.start = at;
      c.full_counts = counts;
      BeltAxis axis(c);
      axis.drive(0, {1, 1});
      axis.drive(kSecond / 10, {1, 1});
      CAPTURE(at, counts);
      CHECK((axis.state().x[BeltState::kCart] - at > 1e-4) == (counts > 100));
    }
  }
}

TEST_CASE("belt axis: a motor that turns back does not pull the cart, however the belt is damped") {
  BeltAxisConfig c = frictionless();
  c.gap = 5e-3;
  c.belt_damping = 2;
  c.start = 0.2;
  BeltAxis axis(c);
  axis.drive(0, {1, 0});
  while (axis.state().v[BeltState::kCart] < 0.02) {
    axis.drive(axis.at() + BeltAxis::kStep, {1, 0});
  }
  double fastest = 0;
  for (int k = 0; k < 2000 && axis.flank(BeltState::kMotor2) == 0; ++k) {
    axis.drive(axis.at() + BeltAxis::kStep, {-1, 0});
    CHECK(axis.state().v[BeltState::kCart] >= fastest);
    fastest = std::max(fastest, axis.state().v[BeltState::kCart]);
  }
  CHECK(axis.state().v[BeltState::kMotor1] < fastest);
}

TEST_CASE("belt axis: its right end is the mirror of its left one, and neither holds the cart") {
  BeltAxisConfig low = frictionless(), high = frictionless();
  low.stop_damping = high.stop_damping = 2;
  low.start = low.stop_low + 0.01;
  high.start = high.stop_high - 0.01;
  BeltAxis left(low), right(high);
  left.drive(0, {-1, -1});
  right.drive(0, {1, 1});
  double back = 0;
  for (int k = 1; k < 20'000; ++k) {
    const double way = k < 8000 ? 1 : 0;
    left.drive(k * BeltAxis::kStep, {-way, -way});
    right.drive(k * BeltAxis::kStep, {way, way});
    const double v = right.state().v[BeltState::kCart];
    REQUIRE(left.state().v[BeltState::kCart] == Approx(-v).margin(1e-9));
    back = std::min(back, v);
  }
  CHECK(back < -0.01);
}

TEST_CASE("belt axis: a cart that leaves its end is not slowed by it") {
  for (const double sense : {-1.0, 1.0}) {
    BeltAxisConfig c = frictionless();
    c.gap = 0.1;  // the cart alone
    c.stop_damping = 3;
    c.start = sense < 0 ? c.stop_low - 1e-3 : c.stop_high + 1e-3;
    BeltAxis axis(c);
    axis.drive(0, {0, 0});
    double fastest = 0;
    for (int k = 1; k < 4000; ++k) {
      axis.drive(k * BeltAxis::kStep, {0, 0});
      const double v = -sense * axis.state().v[BeltState::kCart];
      CAPTURE(sense, k);
      REQUIRE(v >= fastest - 1e-12);
      fastest = v;
    }
    CHECK(fastest > 0.01);
  }
}

TEST_CASE("belt axis: a motor that is open has no force, the other one all of its own") {
  BeltAxis axis(frictionless());
  axis.open(0, true);
  axis.drive(0, {1, 1});
  axis.drive(kSecond / 100, {1, 1});
  CHECK(axis.state().force[0] == 0);
  CHECK(axis.state().force[1] == 1023);
  axis.open(0, false);
  axis.drive(2 * kSecond / 100, {1, 1});
  CHECK(axis.state().force[0] == 1023);
  axis.supply(0.25);
  axis.drive(3 * kSecond / 100, {1, 1});
  CHECK(axis.state().force[0] == Approx(1023 * 0.25));
}

TEST_CASE("belt axis: a motor has its own share of force in each sense") {
  BeltAxisConfig c = frictionless();
  c.left = {0.8, 1.1};
  c.right = {1.2, 0.5};
  for (const double sense : {1.0, -1.0}) {
    BeltAxis axis(c);
    axis.drive(0, {sense, sense});
    axis.drive(kSecond / 100, {sense, sense});
    for (std::size_t m = 0; m < 2; ++m) {
      CHECK(axis.state().force[m] == Approx(sense * 1023 * (sense > 0 ? c.left[m] : c.right[m])));
    }
  }
}

TEST_CASE("belt axis: between two steps it is seen on the line between them") {
  BeltAxis axis(frictionless());
  axis.drive(0, {1, 1});
  axis.drive(kSecond / 10, {1, 1});
  const std::int64_t at = axis.at() / BeltAxis::kStep * BeltAxis::kStep;
  const BeltAxis::Seen a = axis.seen(at), b = axis.seen(at + BeltAxis::kStep);
  REQUIRE(b.x - a.x > 1e-7);
  for (const double share : {0.2, 0.5, 0.8}) {
    const BeltAxis::Seen s = axis.seen(at + std::llround(share * BeltAxis::kStep));
    CHECK(s.x == Approx(a.x + share * (b.x - a.x)).epsilon(1e-12));
    CHECK(s.v == Approx(a.v + share * (b.v - a.v)).epsilon(1e-12));
  }
}

TEST_CASE("stripe track: each error is of its own encoder") {
  const auto codes = [](const plant::StripeTrackConfig& c, double x) {
    const plant::StripeTrack track(c);
    return std::pair{track.code(0, x, 0), track.code(2, x, 0)};
  };
  const plant::StripeTrackConfig none;
  const double at = 0.0006;  // A 804, B 786
  const auto [a, b] = codes(none, at);
  plant::StripeTrackConfig c;
  c.offset_a_error = 0.05;
  CHECK(codes(c, at) == std::pair{a + 20, b});
  c = {};
  c.offset_b_error = 0.05;
  CHECK(codes(c, at) == std::pair{a, b + 20});
  c = {};
  c.amplitude_a_error = 0.1;
  CHECK(codes(c, 0.005) == std::pair{952, 512});
  CHECK(codes(c, 0.00625) == std::pair{512, 912});
  c = {};
  c.amplitude_b_error = 0.1;
  CHECK(codes(c, 0.00625) == std::pair{512, 952});
  c = {};
  c.phase_b_error = 0.05;
  CHECK(codes(c, 0.005) == std::pair{912, 512 + 20});
}
