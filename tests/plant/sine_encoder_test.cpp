// SPDX-License-Identifier: Apache-2.0
#include "models/plant/sine_encoder.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "models/exact/sense/qep.hpp"

using trammel::plant::kPi;
using trammel::plant::SineEncoder;
using trammel::plant::SineEncoderConfig;

namespace {

struct Turn {
  std::int64_t counted = 0;  // by the decoder of the LM628
  int markers = 0;           // all three lines low
};

// Turns the shaft once, a thousandth of a count at a time or more.
Turn turn(const SineEncoderConfig& config, double direction) {
  SineEncoder encoder(config);
  trammel::exact::Qep decoder;
  const auto clock = [&] {
    trammel::exact::Qep::In in;
    in.a = encoder.a();
    in.b = encoder.b();
    in.filter = 1;
    for (int k = 0; k < 6; ++k) decoder.step(in);
  };
  const auto marked = [&] { return !encoder.a() && !encoder.b() && !encoder.marker(); };
  clock();
  Turn result;
  const auto before = decoder.out().count;
  bool was = marked();
  for (int k = 1; k <= 80'000; ++k) {
    encoder.follow(direction * k * 2 * kPi / 80'000);
    clock();
    if (marked() && !was) ++result.markers;
    was = marked();
  }
  result.counted = decoder.out().count - before;
  return result;
}

}  // namespace

TEST_CASE("F-07 a revolution of the sine encoder is 800 counts and one marker, swapped -800") {
  SineEncoderConfig config;
  CHECK(turn(config, 1).counted == 800);
  CHECK(turn(config, 1).markers == 1);
  CHECK(turn(config, -1).counted == -800);
  CHECK(turn(config, -1).markers == 1);
  config.swapped = true;
  CHECK(turn(config, 1).counted == -800);
  CHECK(turn(config, 1).markers == 1);
}

TEST_CASE("sine_encoder's signals swing by 0.5 V around 2.5 V, the marker falls below it once") {
  const SineEncoder encoder(SineEncoderConfig{});
  double low = 5, high = 0;
  int marked = 0;
  for (int k = 0; k < 80'000; ++k) {
    const SineEncoder::Signals s = encoder.signals(k * 2 * kPi / 80'000);
    low = std::fmin(low, s.sine);
    high = std::fmax(high, s.sine);
    if (s.marker < 2.5) ++marked;
    REQUIRE(std::hypot(s.sine - 2.5, s.cosine - 2.5) == Approx(0.5).epsilon(1e-12));
  }
  CHECK(low == Approx(2.0));
  CHECK(high == Approx(3.0));
  CHECK(marked == Approx(80'000 / 200).margin(2));  // one line of the disc
}

TEST_CASE("sine_encoder's comparators hold until a signal has passed its hysteresis") {
  SineEncoderConfig config;
  config.hysteresis = 0.1;
  SineEncoder encoder(config);
  // The cosine crosses the centre half a count from 0, and rises by 0.05 V in asin(0.1) of a line.
  const double count = 2 * kPi / 800;
  const double late = std::asin(0.1) / (kPi / 2);  // [counts]
  encoder.follow((0.5 + late - 0.001) * count);
  CHECK(encoder.count() == 0);
  encoder.follow((0.5 + late + 0.001) * count);
  CHECK(encoder.count() == 1);
  encoder.follow((0.5 - late + 0.001) * count);
  CHECK(encoder.count() == 1);
  encoder.follow((0.5 - late - 0.001) * count);
  CHECK(encoder.count() == 0);
}

TEST_CASE("sine_encoder loses no count to an offset below the amplitude") {
  SineEncoderConfig config;
  config.cosine_offset = 0.3;
  config.sine_offset = -0.2;
  CHECK(turn(config, 1).counted == 800);
  config.cosine_offset = 0.6;
  CHECK(turn(config, 1).counted == 0);
}
