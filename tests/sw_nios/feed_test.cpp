// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <random>

#include "sw_nios/path/feed_prefilter.hpp"
#include "sw_nios/path/feed_real.hpp"
#include "sw_nios/path/feed_sine.hpp"
#include "sw_nios/path/q32.hpp"

namespace {

using namespace trammel;
using sw::Real;

double value(Real a) {  // of numbers below 2^20, to 2^-40
  return std::ldexp(static_cast<double>(a.fixed(40)), -40);
}

std::uint32_t word(std::mt19937& random) { return static_cast<std::uint32_t>(random()); }

}  // namespace

TEST_CASE("sums, products, quotients and roots of the look-ahead are those of doubles") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-8, 8);
  for (int n = 0; n < 20000; ++n) {
    const double a = std::exp2(exponent(random)), b = std::exp2(exponent(random));
    const Real x(static_cast<std::uint64_t>(std::ldexp(a, 50)), 50);
    const Real y(static_cast<std::uint64_t>(std::ldexp(b, 50)), 50);
    CAPTURE(n, a, b);
    // Words of 2^-40, and a truncated operand of 2^-50.
    const auto near = [](double q) { return Approx(q).epsilon(1e-11).margin(1e-11); };
    CHECK(value(x + y) == near(a + b));
    CHECK(value(x - y) == near(std::max(0.0, a - b)));
    CHECK(value(x * y) == near(a * b));
    CHECK(value(x / y) == near(a / b));
    CHECK(value(sqrt(x)) == near(std::sqrt(a)));
    CHECK((x < y) == (a < b));
    CHECK(value(max(x, y)) == near(std::max(a, b)));
  }
}

TEST_CASE("numbers of the look-ahead keep 62 bits, at their ends too") {
  const std::uint64_t most = ~std::uint64_t{0};
  CHECK(Real(0).zero());
  CHECK(Real(most).fixed(0) == most);
  CHECK(Real(most).fixed(1) == most);  // saturated
  CHECK(Real(1).fixed(63) == std::uint64_t{1} << 63);
  CHECK(Real(1, 1).fixed(0) == 1);  // a half is rounded up
  CHECK(Real(1, 2).fixed(0) == 0);
  CHECK((Real(1) / Real(3)).fixed(62) == (std::uint64_t{1} << 62) / 3);
  CHECK((Real(9) / Real(3)).fixed(0) == 3);
  CHECK((Real(most) / Real(most)).fixed(0) == 1);
  CHECK(sqrt(Real(std::uint64_t{1} << 62)).fixed(0) == std::uint64_t{1} << 31);
  CHECK(sqrt(Real(2)).fixed(60) == 1630477228166597777u);  // sqrt(2) 2^60
  CHECK((Real(5) - Real(7)).zero());
  CHECK((Real(7) - Real(7)).zero());
  CHECK((Real(7) + Real()).fixed(0) == 7);
  CHECK((Real() * Real(7)).zero());
  CHECK(sqrt(Real()).zero());
}

TEST_CASE("mul_q62 is the nearest of the whole product, halves away from zero, bit for bit") {
  __extension__ using Wide = __int128;
  std::mt19937 random(62);
  const auto any = [&random] {
    const std::uint64_t both = std::uint64_t{word(random)} << 32 | word(random);
    return static_cast<std::int64_t>(both) >> word(random) % 64;
  };
  for (int n = 0; n < 20'000; ++n) {
    const std::int64_t a = any(), b = any();
    const Wide product = Wide{a} * b, size = product < 0 ? -product : product;
    const Wide nearest = (size + (Wide{1} << 61)) >> 62;
    if (nearest >= Wide{1} << 63) continue;
    const auto wanted = static_cast<std::int64_t>(product < 0 ? -nearest : nearest);
    CAPTURE(n, a, b);
    if (sw::mul_q62(a, b) != wanted) REQUIRE(sw::mul_q62(a, b) == wanted);
  }
}

TEST_CASE("cosine and sine are within 2^-29, and exact at quarters of a turn") {
  std::mt19937 random(2);
  double worst = 0;
  for (int n = 0; n < 200000; ++n) {
    const std::uint32_t angle = n < 64 ? static_cast<std::uint32_t>(n) << 26 : word(random);
    const sw::CosSin s = sw::cos_sin(angle);
    const double turn = 6.28318530717958647693 * std::ldexp(angle, -32);
    worst = std::max({worst, std::abs(std::ldexp(s.cos, -30) - std::cos(turn)),
                      std::abs(std::ldexp(s.sin, -30) - std::sin(turn))});
  }
  CHECK(worst < std::ldexp(1, -29));
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
    const sw::CosSin s = sw::cos_sin(quarter << 30);
    const std::int32_t one = 1 << 30;
    CHECK(s.cos == (quarter == 0 ? one : quarter == 2 ? -one : 0));
    CHECK(s.sin == (quarter == 1 ? one : quarter == 3 ? -one : 0));
  }
}

TEST_CASE("the pre-filter gives the control words of the specification") {
  CHECK(sw::prefilter(0, 256, 1000) == 175);
  CHECK(sw::prefilter(1000, 1000, 1000) == 1000);
  CHECK(sw::prefilter(-5, 0, 7) == 0);
  CHECK(sw::prefilter(-33554432, 33554431, -33554432) == 55924735);  // the whole table at once

  sw::Prefilter filter({1000, -2000});
  CHECK((filter.step({1000, -2000}) == sw::Point{1000, -2000}));
  CHECK((filter.step({1600, -2600}) == sw::Point{900, -1900}));  // of the point before
  CHECK((filter.step({1600, -2600}) == sw::Point{1700, -2700}));
  CHECK((filter.step({1600, -2600}) == sw::Point{1600, -2600}));
}
