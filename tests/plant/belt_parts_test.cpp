// SPDX-License-Identifier: Apache-2.0
//
// Single parts of the belt axis and the stripes: ramps of friction, contacts that push only, the
// right end as the left one, a motor that is open, what is seen between two steps, errors of B.
#include <catch2/catch.hpp>
#include <algorithm>
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
  c.zone_more = c.winding = c.coulomb = c.stiction = c.viscous = 0;
  return c;
}

}  // namespace

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
  BeltAxisConfig c = smooth();
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
  BeltAxisConfig low = smooth(), high = smooth();
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
    BeltAxisConfig c = smooth();
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
  BeltAxis axis(smooth());
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
  BeltAxisConfig c = smooth();
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
  BeltAxis axis(smooth());
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
