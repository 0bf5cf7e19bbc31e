// SPDX-License-Identifier: Apache-2.0

#include "models/fixed/fixed.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace fixed = trammel::fixed;

TEST_CASE("fixed sat clips to the ends of a two's complement word") {
  REQUIRE(fixed::sat(2047, 12) == 2047);
  REQUIRE(fixed::sat(2048, 12) == 2047);
  REQUIRE(fixed::sat(-2048, 12) == -2048);
  REQUIRE(fixed::sat(-2049, 12) == -2048);
  REQUIRE(fixed::sat(8388608, 24) == 8388607);
  REQUIRE(fixed::sat(-8388609, 24) == -8388608);
  REQUIRE(fixed::sat(0, 12) == 0);
}

TEST_CASE("fixed clip keeps both of its limits") {
  REQUIRE(fixed::clip(-1537, -1536, 1535) == -1536);
  REQUIRE(fixed::clip(1536, -1536, 1535) == 1535);
  REQUIRE(fixed::clip(7, -1536, 1535) == 7);
}

TEST_CASE("fixed rs rounds half up, also below zero, and shifts left for s <= 0") {
  REQUIRE(fixed::rs(5, 1) == 3);    // 2.5
  REQUIRE(fixed::rs(-5, 1) == -2);  // -2.5
  REQUIRE(fixed::rs(3, 2) == 1);    // 0.75
  REQUIRE(fixed::rs(-6, 2) == -1);  // -1.5
  REQUIRE(fixed::rs(-7, 2) == -2);  // -1.75
  REQUIRE(fixed::rs(1024, 11) == 1);
  REQUIRE(fixed::rs(1023, 11) == 0);
  REQUIRE(fixed::rs(-1024, 11) == 0);
  REQUIRE(fixed::rs(-1025, 11) == -1);
  REQUIRE(fixed::rs(9, 0) == 9);
  REQUIRE(fixed::rs(-9, -3) == -72);
}

TEST_CASE("fixed rs is floor(x / 2^s + 1/2)") {
  std::mt19937_64 random(15);
  for (int i = 0; i < 20000; ++i) {
    // 48 bits and a half are exact in double precision.
    const std::int64_t x = fixed::wrap(static_cast<std::int64_t>(random()), 48);
    const int s = 1 + static_cast<int>(random() % 24);
    REQUIRE(static_cast<double>(fixed::rs(x, s)) ==
            std::floor(std::ldexp(static_cast<double>(x), -s) + 0.5));
  }
}

TEST_CASE("fixed floor_shift rounds down") {
  REQUIRE(fixed::floor_shift(-1, 6) == -1);
  REQUIRE(fixed::floor_shift(-64, 6) == -1);
  REQUIRE(fixed::floor_shift(-65, 6) == -2);
  REQUIRE(fixed::floor_shift(63, 6) == 0);
}

TEST_CASE("fixed wrap keeps the low bits of a word as a register does") {
  REQUIRE(fixed::wrap(8388608, 24) == -8388608);
  REQUIRE(fixed::wrap(-8388609, 24) == 8388607);
  REQUIRE(fixed::wrap(0x1FFFFFFFF, 32) == -1);
  REQUIRE(fixed::wrap(-5, 12) == -5);
}

TEST_CASE("fixed gain of the specification has its printed value") {
  REQUIRE(fixed::Gain{768, 0}.value() == 0.375);
  REQUIRE(fixed::Gain{1884, 1}.value() == Approx(1.840).epsilon(1e-3));
  REQUIRE(fixed::Gain{839, -7}.value() == Approx(0.0032).epsilon(1e-2));
  REQUIRE(fixed::Gain{1478, -2}.value() == Approx(0.1804).epsilon(1e-3));
}
