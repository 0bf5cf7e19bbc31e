// SPDX-License-Identifier: Apache-2.0
//
// Encoders of lines and of sines.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "models/exact/sense/qep.hpp"
#include "models/plant/encoder.hpp"
#include "models/plant/sine_encoder.hpp"

using trammel::plant::Encoder;
using trammel::plant::EncoderConfig;
using trammel::plant::kPi;
using trammel::plant::SineEncoder;
using trammel::plant::SineEncoderConfig;

namespace {

int lines(const Encoder& e) { return (e.a() ? 1 : 0) | (e.b() ? 2 : 0); }

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

TEST_CASE("A leads B when counting up") {
  Encoder e(EncoderConfig{}, 0);
  const int up[] = {0b00, 0b01, 0b11, 0b10};
  for (int k = 0; k < 40; ++k) {
    REQUIRE(e.count() == k);
    REQUIRE(lines(e) == up[k % 4]);
    e.follow((k + 1) * 5e-6);
  }
  for (int k = 40; k > -40; --k) {
    REQUIRE(e.count() == k);
    REQUIRE(lines(e) == up[(k + 400) % 4]);
    e.follow((k - 1) * 5e-6);
  }
}

TEST_CASE("without hysteresis the count is floor(x/5um + 0.5)") {
  EncoderConfig c;
  c.hysteresis = 0;
  Encoder e(c, 0);
  for (int k = 0; k < 5000; ++k) {
    const double x = 1e-4 * std::sin(k * 0.003) + 3.1e-8;
    e.follow(x);
    REQUIRE(e.count() == static_cast<long>(std::floor(x / 5e-6 + 0.5)));
  }
}

TEST_CASE("hysteresis is 0.2 count wide and centred on the boundary") {
  Encoder e(EncoderConfig{}, 0);
  e.follow(0.599 * 5e-6);
  CHECK(e.count() == 0);
  e.follow(0.601 * 5e-6);
  CHECK(e.count() == 1);
  e.follow(0.401 * 5e-6);
  CHECK(e.count() == 1);
  e.follow(0.399 * 5e-6);
  CHECK(e.count() == 0);
}

TEST_CASE("the index is one count wide at its place") {
  Encoder e(EncoderConfig{}, 0.25 - 15e-6);
  int high = 0;
  for (int k = 0; k < 60; ++k) {
    e.follow(0.25 - 15e-6 + k * 5e-7);
    if (e.z()) {
      ++high;
      REQUIRE(e.count() == 50000);
    }
  }
  CHECK(high == 10);
}

TEST_CASE("a sub-divisional error moves the boundaries by a sine of the scale's period") {
  EncoderConfig c;
  c.hysteresis = 0;
  c.error = 2e-6;
  c.period = 20e-6;
  Encoder e(c, 0);
  double worst = 0;
  std::int64_t last = e.count();
  for (int k = 0; k < 40000; ++k) {
    const double x = k * 5e-9;
    e.follow(x);
    if (e.count() == last) continue;
    last = e.count();
    const double boundary = (static_cast<double>(last) - 0.5) * 5e-6;
    const double error = x - boundary - 2e-6 * std::sin(2 * trammel::plant::kPi * boundary / 20e-6);
    REQUIRE(std::abs(error) <= 6e-9);
    worst = std::max(worst, std::abs(x - boundary));
  }
  CHECK(last == 40);
  CHECK(worst > 1.4e-6);  // the sine at an eighth of its period
}

TEST_CASE("jitter scatters each boundary of a count by itself") {
  EncoderConfig c;
  c.jitter = 0.1e-6;
  Encoder e(c, 0);
  double low = 0, high = 0, product = 0;  // sums over the crossings [um^2], from the middle
  for (int k = 0; k < 2000; ++k) {
    e.follow(k % 2 == 0 ? e.high() : e.low() - 1e-9);
    const double at = static_cast<double>(e.count()) * 5e-6;
    const double below = 1e6 * (e.low() - (at - 3e-6)), above = 1e6 * (e.high() - (at + 3e-6));
    low += below * below;
    high += above * above;
    product += below * above;
  }
  CHECK(std::sqrt(low / 2000) == Approx(0.1).epsilon(0.1));
  CHECK(std::sqrt(high / 2000) == Approx(0.1).epsilon(0.1));
  CHECK(std::abs(product) < 0.1 * std::sqrt(low * high));
}

TEST_CASE("jitter scatters the crossings of a boundary within the hysteresis, by the seed") {
  EncoderConfig c;
  c.jitter = 0.1e-6;
  c.hysteresis = 0.2;
  const auto crossings = [&](std::uint64_t seed) {
    c.seed = seed;
    Encoder e(c, 0);
    std::vector<double> at;
    for (int turn = 0; turn < 200; ++turn) {
      for (int k = 0; k <= 1600; ++k) {
        const double x = 2e-6 + k * 1e-9;  // 0.4 to 0.72 counts
        const auto before = e.count();
        e.follow(x);
        if (e.count() > before) at.push_back(x);
        REQUIRE(e.count() >= 0);
      }
      e.follow(1e-6);
      REQUIRE(e.count() == 0);
    }
    return at;
  };
  const std::vector<double> one = crossings(1);
  CHECK(one == crossings(1));
  CHECK(one != crossings(2));
  const auto [low, high] = std::minmax_element(one.begin(), one.end());
  CHECK(*high - *low > 0.2e-6);
  CHECK(*low > 2.49e-6);  // the falling boundary ends there
}

TEST_CASE("an encoder of any count, hysteresis, index and scale has its own boundaries") {
  EncoderConfig c;
  c.count = 2e-6;
  c.hysteresis = 0.5;
  c.index = -31.1e-6;
  c.error = 0.4e-6;
  c.period = 14e-6;
  Encoder e(c, 0.7e-3);
  CHECK(std::abs(static_cast<double>(e.count()) - 350) <= 1);
  const auto boundary = [](double counts) {
    return 2e-6 * counts + 0.4e-6 * std::sin(2 * trammel::plant::kPi * counts * 2e-6 / 14e-6);
  };
  while (e.count() > -40) {
    const auto k = static_cast<double>(e.count());
    CAPTURE(e.count());
    REQUIRE(e.low() == Approx(boundary(k - 0.5) - 0.25 * 2e-6).margin(1e-15));
    REQUIRE(e.high() == Approx(boundary(k + 0.5) + 0.25 * 2e-6).margin(1e-15));
    // From `high` on it rises, below `low` it falls.
    REQUIRE(e.leaves(e.high()));
    REQUIRE_FALSE(e.leaves(std::nextafter(e.high(), -1)));
    REQUIRE_FALSE(e.leaves(e.low()));
    REQUIRE(e.leaves(std::nextafter(e.low(), -1)));
    REQUIRE(e.z() == (e.count() == -16));
    e.follow(std::nextafter(e.low(), -1));
  }
}

TEST_CASE("jitter never takes a boundary out of its hysteresis, however large it is") {
  EncoderConfig c;
  c.count = 3e-6;
  c.hysteresis = 0.4;
  c.jitter = 1e-3;
  Encoder e(c, 0);
  int at_its_most = 0;
  for (int k = 0; k < 500; ++k) {
    const auto at = static_cast<double>(e.count()) * 3e-6;
    const double below = e.low() - (at - 0.7 * 3e-6), above = e.high() - (at + 0.7 * 3e-6);
    CAPTURE(k, below, above);
    REQUIRE(std::abs(below) <= 0.2 * 3e-6 * 2);
    REQUIRE(std::abs(above) <= 0.2 * 3e-6 * 2);
    REQUIRE(e.low() < e.high());
    at_its_most += std::abs(std::abs(above) - 0.499 * 0.4 * 3e-6) < 1e-12 ? 1 : 0;
    e.follow(k % 3 != 0 ? e.high() : e.low() - 1e-9);
  }
  CHECK(at_its_most > 490);
}

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
