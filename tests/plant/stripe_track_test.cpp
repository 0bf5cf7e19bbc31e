// SPDX-License-Identifier: Apache-2.0
//
// The stripes' sensor of other values than the default ones, against its definition.
#include "models/plant/stripe_track.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using trammel::plant::StripeTrack;
using trammel::plant::StripeTrackConfig;

namespace {

constexpr double kTurn = 6.283185307179586;

StripeTrackConfig own() {
  StripeTrackConfig c;
  c.period = 8e-3;
  c.amplitude = 300;
  c.amplitude_a_error = 0.1;
  c.amplitude_b_error = -0.2;
  c.offset_a_error = 0.05;
  c.offset_b_error = -0.07;
  c.phase_b_error = 0.3;
  c.dot_codes = 200;
  c.dot_speed = 0.8;
  c.defect_units = {0, 0};
  return c;
}

}  // namespace

TEST_CASE("stripe track: each channel is sine or cosine with its own errors, or their derivative") {
  const StripeTrackConfig c = own();
  const StripeTrack track(c);
  for (int k = -200; k < 200; ++k) {
    const double x = k * 1.7e-4, v = 0.004 * k, angle = kTurn * x / 8e-3;
    const double rate = 200 * v / 0.8;
    CAPTURE(x, v);
    CHECK(track.code(0, x, v) == std::lround(512 + 300 * (0.05 + 1.1 * std::cos(angle))));
    CHECK(track.code(1, x, v) == std::lround(512 - rate * 1.1 * std::sin(angle)));
    CHECK(track.code(2, x, v) == std::lround(512 + 300 * (-0.07 + 0.8 * std::sin(angle + 0.3))));
    CHECK(track.code(3, x, v) == std::lround(512 + rate * 0.8 * std::cos(angle + 0.3)));
    CHECK(track.code(4, x, v) == 512);
    CHECK(track.code(7, x, v) == 512);
  }
}

TEST_CASE("stripe track: noise has its rms, each channel and each clock its own, by the seed") {
  StripeTrackConfig c = own();
  c.noise = 3;
  c.dot_noise = 7;
  const StripeTrack track(c), same(c), clean(own());
  c.seed = 2;
  const StripeTrack other(c);
  constexpr double kX = 1e-3, kV = 0.1;
  constexpr int kCount = 20'000;
  for (const int channel : {0, 1, 2, 3}) {
    double mean = 0, square = 0;
    int repeats = 0, as_other = 0, as_next = 0;
    for (int n = 0; n < kCount; ++n) {
      const double off = track.code(channel, kX, kV, n) - clean.code(channel, kX, kV, n);
      mean += off / kCount;
      square += off * off / kCount;
      repeats += track.code(channel, kX, kV, n) == same.code(channel, kX, kV, n) ? 1 : 0;
      as_other += track.code(channel, kX, kV, n) == other.code(channel, kX, kV, n) ? 1 : 0;
      as_next += track.code(channel, kX, kV, n) == track.code(channel, kX, kV, n + 1) ? 1 : 0;
    }
    const double rms = channel % 2 == 0 ? 3 : 7;
    CAPTURE(channel, mean, square);
    CHECK(mean == Approx(0).margin(0.5));  // codes are whole: the clean one is rounded, too
    CHECK(std::sqrt(square) == Approx(rms).epsilon(0.05));
    CHECK(repeats == kCount);
    CHECK(as_other < kCount / 5);
    CHECK(as_next < kCount / 5);
  }
  CHECK(track.code(4, kX, kV, 1) == 512);
}

TEST_CASE("stripe track: codes end at 0 and 1023") {
  StripeTrackConfig c = own();
  c.amplitude = 900;
  c.offset_a_error = c.offset_b_error = c.amplitude_a_error = c.amplitude_b_error = 0;
  c.phase_b_error = 0;
  const StripeTrack track(c);
  CHECK(track.code(0, 0, 0) == 1023);
  CHECK(track.code(0, 4e-3, 0) == 0);
  CHECK(track.code(2, 2e-3, 0) == 1023);
  CHECK(track.code(2, 6e-3, 0) == 0);
  CHECK(track.code(3, 0, 3) == 1023);
  CHECK(track.code(3, 0, -3) == 0);
  CHECK(track.code(1, 2e-3, -3) == 1023);
  CHECK(track.code(1, 2e-3, 3) == 0);
}

// The derivative of a displaced stripe, of which the velocity is made.
TEST_CASE("stripe track: derivatives are those of the codes, over a defect as elsewhere") {
  StripeTrackConfig c = own();
  c.defect_at = {0.02, 0.05};
  c.defect_units = {100, -60};
  const StripeTrack track(c);
  constexpr double kStep = 1e-7, kSpeed = 0.5;  // [m], [m/s]
  for (const double place : {0.018, 0.01905, 0.02, 0.02095, 0.04905, 0.05, 0.05095}) {
    const double angle = kTurn * track.seen(place) / c.period;
    const double rate =
        200 * kSpeed / 0.8 * (track.seen(place + kStep) - track.seen(place - kStep)) / (2 * kStep);
    CAPTURE(place);
    CHECK(track.code(1, place, kSpeed) == std::lround(512 - rate * 1.1 * std::sin(angle)));
    CHECK(track.code(3, place, kSpeed) == std::lround(512 + rate * 0.8 * std::cos(angle + 0.3)));
  }
}

TEST_CASE("stripe track: a defect has its width, with edges of 0.1 mm inside, each by itself") {
  StripeTrackConfig c = own();
  c.defect_at = {0.02, 0.05};
  c.defect_units = {100, -60};
  c.defect_width = 3e-3;
  const StripeTrack track(c);
  const double unit = 8e-3 / 16384;
  for (std::size_t k = 0; k < 2; ++k) {
    for (const double side : {-1.0, 1.0}) {
      const auto shift = [&](double from_middle) {
        const double x = c.defect_at[k] + side * from_middle;
        return (track.seen(x) - x) / unit;
      };
      CAPTURE(k, side);
      CHECK(shift(0) == Approx(c.defect_units[k]));
      CHECK(shift(1.39e-3) == Approx(c.defect_units[k]));
      CHECK(shift(1.45e-3) == Approx(0.5 * c.defect_units[k]));
      CHECK(shift(1.49e-3) == Approx(0.1 * c.defect_units[k]));
      CHECK(shift(1.51e-3) == Approx(0).margin(1e-6));
    }
  }
}
