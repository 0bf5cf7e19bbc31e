// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>

#include "lab/response.hpp"

using namespace trammel::lab;

namespace {

constexpr double kPi = 3.14159265358979323846;

// T of an open loop over 1 to 1000 Hz, 40 points a decade.
template <class Loop>
Response closed_of(Loop open) {
  Response closed;
  for (int k = 0; k <= 120; ++k) {
    const double hz = std::pow(10, k / 40.0);
    const std::complex<double> gain = open(std::complex<double>(0, 2 * kPi * hz));
    closed.push_back({hz, gain / (1.0 + gain)});
  }
  return closed;
}

}  // namespace

TEST_CASE("a tone through a first-order filter gives the filter's gain at that frequency") {
  constexpr double kPart = 0.2;  // y += kPart (u - y)
  for (const std::size_t period : {4u, 25u, 100u}) {
    ToneSum in(period), out(period);
    double y = 0;
    for (std::size_t k = 0; k < 20 * period + 200; ++k) {
      const double u = std::sin(2 * kPi * static_cast<double>(k) / static_cast<double>(period));
      y += kPart * (u - y);
      if (k < 200 + 10 * period) continue;  // 0.8^240 is below 1e-23
      in.add(u);
      out.add(y);
    }
    const std::complex<double> z = std::polar(1.0, 2 * kPi / static_cast<double>(period));
    const std::complex<double> expected = kPart * z / (z - (1 - kPart));
    CHECK(std::abs(out.sum() / in.sum() - expected) < 1e-9);
  }
}

TEST_CASE("a tone's sum turns back by a part of its period for each value before") {
  for (const std::size_t period : {4u, 25u}) {
    for (std::size_t at = 0; at < 2 * period; ++at) {  // of an impulse there
      ToneSum tone(period);
      for (std::size_t k = 0; k < 2 * period; ++k) tone.add(k == at ? 3 : 0);
      const double turn = 2 * kPi * static_cast<double>(at) / static_cast<double>(period);
      CAPTURE(period, at);
      CHECK(std::abs(tone.sum() - std::complex<double>(3 * std::cos(turn), -3 * std::sin(turn))) <
            1e-12);
    }
  }
}

TEST_CASE("an integrating loop has its bandwidth at its crossover and 90 degrees of margin") {
  const Margins m = margins(closed_of([](auto s) { return 2 * kPi * 50 / s; }));
  REQUIRE(m.bandwidth_hz);
  CHECK(*m.bandwidth_hz == Approx(50).epsilon(0.002));  // lines between the points
  CHECK(*m.crossover_hz == Approx(50).epsilon(1e-3));
  CHECK(*m.phase_margin_deg == Approx(90).margin(1e-6));
  CHECK_FALSE(m.gain_margin_db);
  CHECK(m.peak_hz == 1);
}

TEST_CASE("a bandwidth is 3 dB below the first point, on a line over the logarithm of frequency") {
  const Margins m = margins({{10, 0.5}, {1000, 0.25}});
  REQUIRE(m.bandwidth_hz);
  CHECK(*m.bandwidth_hz == Approx(100).epsilon(1e-6));  // half of 6.02 dB
  CHECK(m.peak_db == Approx(20 * std::log10(0.5)));
}

TEST_CASE("of equal peaks the first is told, and a point on a border is no crossing yet") {
  const Margins m = margins({{1, 0.5}, {2, 2}, {4, 2}, {8, 0.5}});
  CHECK(m.peak_hz == 2);
  CHECK(m.peak_db == Approx(20 * std::log10(2.0)));
  // An open loop of exactly 1 at 10 Hz, from where it falls.
  const auto closed = [](double open) { return std::complex<double>(open / (1 + open)); };
  const Margins at = margins({{5, closed(2)}, {10, closed(1)}, {20, closed(0.5)}});
  REQUIRE(at.crossover_hz);
  CHECK(*at.crossover_hz == Approx(10));
}

TEST_CASE("three equal lags have a gain margin of 8 over their gain, where they turn by 180") {
  const double w = 2 * kPi * 20;
  const Margins m = margins(closed_of([w](auto s) {
    return 4.0 / std::pow(1.0 + s / w, 3);
  }));
  REQUIRE(m.gain_margin_db);
  CHECK(*m.gain_margin_db == Approx(20 * std::log10(2.0)).margin(0.01));
  CHECK(*m.reversal_hz == Approx(20 * std::sqrt(3.0)).epsilon(0.001));
  const double crossover = std::sqrt(std::pow(4, 2.0 / 3) - 1);  // of w
  CHECK(*m.crossover_hz == Approx(20 * crossover).epsilon(0.001));
  CHECK(*m.phase_margin_deg == Approx(180 - 3 * std::atan(crossover) * 180 / kPi).margin(0.1));
  CHECK(m.peak_db > 3);
  CHECK(m.peak_hz == Approx(20 * crossover).epsilon(0.2));
}

TEST_CASE("the first phase lies between -270 and 90 degrees, the others beside the one before") {
  const auto at = [](double degree) { return std::polar(2.0, degree * kPi / 180); };
  for (const double first : {80.0, 10.0, -100.0, -170.0, -190.0, -260.0}) {
    const std::vector<double> degrees = phases({{1, at(first)}, {2, at(first - 100)}});
    REQUIRE(degrees.size() == 2);
    CHECK(degrees[0] == Approx(first));
    CHECK(degrees[1] == Approx(first - 100));
  }
}

TEST_CASE("two integrators begin at -180 degrees, not at 180") {
  const Margins m = margins(closed_of([](auto s) {
    const double w = 2 * kPi * 30;
    return w * w / (s * s) * (1.0 + 2.0 * s / w);
  }));
  REQUIRE(m.phase_margin_deg);
  CHECK(*m.phase_margin_deg == Approx(std::atan(2 * *m.crossover_hz / 30) * 180 / kPi).margin(0.1));
}

TEST_CASE("what the measured frequencies do not enclose is not given") {
  CHECK_FALSE(margins({}).bandwidth_hz);
  const Response flat{{1, 0.99}, {10, {0.98, -0.05}}};
  const Margins m = margins(flat);
  CHECK_FALSE(m.bandwidth_hz);
  CHECK_FALSE(m.crossover_hz);
  CHECK_FALSE(m.gain_margin_db);
}
