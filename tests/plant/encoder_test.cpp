// SPDX-License-Identifier: Apache-2.0
#include "models/plant/encoder.hpp"

#include <catch2/catch.hpp>

using trammel::plant::Encoder;
using trammel::plant::EncoderConfig;

namespace {
int lines(const Encoder& e) { return (e.a() ? 1 : 0) | (e.b() ? 2 : 0); }
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
