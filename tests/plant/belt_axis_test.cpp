// SPDX-License-Identifier: Apache-2.0
//
// Cart, belt and motors against closed forms, their energy, and themselves at other steps.
#include <catch2/catch.hpp>
#include <cmath>

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
