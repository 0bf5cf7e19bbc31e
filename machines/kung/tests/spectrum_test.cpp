// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/spectrum.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace trammel::kung;

namespace {

constexpr double kPi = 3.14159265358979323846;

// Of a sine of m + offset/2048 of the rate.
std::vector<double> of_sine(std::size_t n, double m, double amplitude, double mean = 0) {
  return spectrum(n, [=](std::size_t k) {
    return mean + amplitude * std::sin(2 * kPi * m * static_cast<double>(k) / kSegment + 0.3);
  });
}

}  // namespace

TEST_CASE("a sine shows with its amplitude at its frequency, and nowhere else") {
  for (const std::size_t n : {kSegment, kSegment + 1, 3 * kSegment, 10000ul}) {
    CAPTURE(n);
    const auto all = of_sine(n, 100, 2.5, 40);
    REQUIRE(all.size() == kSegment / 2 + 1);
    CHECK(all[100] == Approx(2.5).epsilon(1e-3));
    CHECK(all[101] == Approx(1.25).epsilon(1e-2));  // Hann: half of it beside it
    for (const std::size_t m : {0, 1, 97, 103, 500, 1024}) {
      CAPTURE(m);
      CHECK(all[m] < 1e-3);
    }
  }
}

TEST_CASE("between two frequencies a sine shows at both, at most 15 percent lower") {
  const auto all = of_sine(5000, 300.5, 1);
  CHECK(all[300] == Approx(0.849).epsilon(1e-2));
  CHECK(all[301] == Approx(0.849).epsilon(1e-2));
}

TEST_CASE("a short series is one segment, and of a very short one there is nothing") {
  const auto all = of_sine(512, 200, 3);
  CHECK(all[200] == Approx(3).epsilon(1e-2));
  CHECK(of_sine(15, 200, 1).empty());
}

TEST_CASE("of noise the powers of the segments are averaged") {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> values(200 * kSegment);
  for (double& one : values) one = normal(random);
  const auto all = spectrum(values.size(), [&](std::size_t k) { return values[k]; });
  // Variance 1 over the window: amplitude 2 sqrt(sum w^2) / sum w = 2 sqrt(3/2 / n).
  const double expected = 2 * std::sqrt(1.5 / kSegment);
  for (std::size_t m = 4; m < 1020; m += 50) CHECK(all[m] == Approx(expected).epsilon(0.2));
}
