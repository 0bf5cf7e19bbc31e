// SPDX-License-Identifier: Apache-2.0
//
// What firmware of the precision controller computes around its estimator: words, identification
// move, learned corrections.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <memory>

#include "sw_nios/apps/kung/identification.hpp"
#include "sw_nios/apps/kung/learning.hpp"
#include "sw_nios/apps/kung/precision_values.hpp"

using namespace trammel::sw;

namespace {

using namespace trammel::sw;

constexpr double kPi = 3.14159265358979323846;
constexpr double kKilogram = 54681.6;

double value(Gain g) { return std::ldexp(g.mant / 2048.0, g.exp); }
std::int32_t mass(double kg) { return static_cast<std::int32_t>(std::lround(kKilogram * kg)); }
Gain km(double kg) { return normalized(mass(kg), 21); }

constexpr std::uint32_t kLap = 60, kGain = 1u << 14;
constexpr std::int32_t kErrSum = 32 * 100;

using Table = std::array<std::int16_t, Corrections::kPoints>;

// After three laps in which the axis goes this way from point to point and is off by as much.
Table learned(std::int32_t way) {
  Table table{};
  table.fill(77);  // of a run before
  Learning learning(&table, kLap, kGain);
  for (std::uint32_t point = 0; point < 3 * kLap; ++point) learning.step(point, way, kErrSum);
  return table;
}

}  // namespace

namespace Catch {
template <>
struct StringMaker<Gain> {
  static std::string convert(const Gain& g) {
    return std::to_string(g.mant) + ", " + std::to_string(g.exp);
  }
};
}  // namespace Catch

TEST_CASE("the words of masses and frictions are those of the specification") {
  CHECK(km(2.5) == Gain{1068, -3});
  CHECK(km(8) == Gain{1709, -2});
  CHECK(km(13.5) == Gain{1442, -1});
  CHECK(km(25) == Gain{1335, 0});
  CHECK(km(30.5) == Gain{1629, 0});
  CHECK(km(15.6) == Gain{1666, -1});
  CHECK(inverse(km(15.6)) == Gain{1258, 2});
  CHECK(inverse(km(25)) == Gain{1570, 1});  // 1571 is the nearest, by the rule it is the floor
  CHECK(normalized(559940, 22) == Gain{1094, -2});
  EstimatorSetup s;
  s.coulomb = 209978;
  const KnotWords words = knot_words({853034, 559940, s.coulomb, 0, 0, 0}, s);
  CHECK(words.km == Gain{1666, -1});
  CHECK(words.kmi == Gain{1258, 2});
  CHECK(words.kb == Gain{1094, -2});
  CHECK(words.fc == 6562);
}

TEST_CASE("a change from 8 to 10 kg is the specification's") {
  CHECK(km(10) == Gain{1068, -1});
  CHECK(inverse(km(10)) == Gain{1963, 2});
  CHECK(mass_ratio(km(8), km(10)) == -6551);
  CHECK(mass_ratio(km(8), km(8)) == 0);
}

TEST_CASE("a gain is the nearest of 11 bits, up to its ends") {
  CHECK(normalized(0, 22) == Gain{});
  for (std::int32_t x = 1; x > 0 && x < 0x7FFFFFFF - x / 7; x += 1 + x / 7) {
    CAPTURE(x);
    const Gain g = normalized(x, 21);
    if (g.exp > -16) {
      CHECK(g.mant >= 1024);
      CHECK(g.mant <= 2047);
      CHECK(value(g) == Approx(std::ldexp(x, -21)).epsilon(0.5001 / 1024));
    } else {
      CHECK(std::abs(value(g) - std::ldexp(x, -21)) <= std::ldexp(1, -27));
    }
    if (g.mant < 1024) continue;
    CHECK(inverse(g).mant >= 1024);
    CHECK(inverse(g).mant <= 2047);
    CHECK(value(inverse(g)) * value(g) == Approx(1).epsilon(1e-3));
  }
  CHECK(normalized(0x7FFFFFFF, 21) == Gain{1024, 11});
  CHECK(normalized(4095, 12) == Gain{1024, 1});  // 2047.5 becomes 2048
  CHECK(inverse({1024, 3}) == Gain{1024, -1});
}

TEST_CASE("the ratio of two masses keeps the current, up to a quarter either way") {
  for (double kg = 0.5; kg < 45; kg *= 1.07) {
    for (const double change : {0.75, 0.8, 0.99, 1.01, 1.2, 1.25}) {
      CAPTURE(kg, change);
      const double ratio = mass_ratio(km(kg), km(kg * change)) / 32768.0;
      CHECK(ratio == Approx(value(km(kg)) / value(km(kg * change)) - 1).margin(4e-5));
    }
  }
  CHECK(mass_ratio({2047, 3}, {1024, 1}) == 32767);  // more than a word says
}

TEST_CASE("the current against cogging and force is that of the point between two knots") {
  const Estimator::Theta theta{0, 0, 0, 131236, -43745, 21873};
  for (std::int32_t from = -9'000'000; from < 9'000'000; from += 77'777) {
    const std::int32_t to = from + 9000;
    const double at = std::floor((3.0 * from + to) / 4) / 256 / 6100;
    const double newton = 3 * std::sin(2 * kPi * at) - std::cos(2 * kPi * at) + 0.5;
    CAPTURE(from);
    // 1 N is 5.34 LSB of i_q*, 256 steps each; the table of the sine has 1024 steps a turn.
    CHECK(force_current(theta, from, to, 48800) == Approx(5.34 * 256 * newton).margin(30));
  }
  CHECK(force_current({0, 0, 0, 0, 0, 1 << 23}, 0, 0, 48800) == 262144);
  CHECK(force_current({0, 0, 0, 1 << 28, 1 << 28, 0}, 0, 0, 48800) == 524287);
  CHECK(force_current({0, 0, 0, 0, -(1 << 28), 0}, 0, 0, 48800) == -524287);
}

TEST_CASE("the identification move is three waves of 0.8 mm between rests") {
  for (std::uint32_t n = 0; n < Identification::kPoints; ++n) {
    CAPTURE(n);
    const bool moves = n >= 16 && n < 112;
    const double ideal = moves ? 80 * (1 - std::cos(2 * kPi * (n - 16) / 32)) : 0;  // [count]
    CHECK(Identification::offset(n, 40960) / 256.0 == Approx(ideal).margin(0.05));
    CHECK(std::abs(Identification::offset(n, -40960) + Identification::offset(n, 40960)) <= 1);
  }
  CHECK(Identification::offset(32, 40960) == 40960);  // 160 counts
  CHECK(Identification::offset(16, 40960) == 0);
  CHECK(Identification::offset(32, 2'048'000) == 2'048'000);  // of an encoder of 0.1 um
  CHECK(Identification::kFull == 118);
  CHECK(Identification::kPoints == 144);
}

TEST_CASE("sines are those of a table of 1024 rounded values") {
  for (std::int32_t k = -3000; k < 3000; ++k) {
    CAPTURE(k);
    CHECK(sine1024(k) == std::lround(1024 * std::sin(2 * kPi * k / 1024)));
  }
}

namespace {

using Points = std::array<std::int16_t, Corrections::kPoints>;

// An axis on a lap of 400 points whose error to its set point is the same in every lap.
struct Laps {
  std::unique_ptr<Points> points = std::make_unique<Points>();
  std::uint32_t lap = 400;
  double largest(std::uint32_t laps, double gain, std::int32_t way = 3000) {
    points->fill(111);  // of another path
    Learning learning(points.get(), lap, static_cast<std::uint32_t>(std::ldexp(gain, 16)));
    double most = 0;
    std::array<double, 4096> off{};
    for (std::uint32_t n = 0; n < laps * lap; ++n) {
      const std::uint32_t at = n % lap;
      const double wrong = at < 20 || at > 380 ? 0 : 90 * std::sin(at * 0.05);
      off[n % 4096] = wrong;
      // The error of a knot: of the points 2 and 3 before, where there are some.
      const auto of = [&](std::uint32_t back) { return n < back ? 0 : off[(n - back) % 4096]; };
      learning.step(n, way, static_cast<std::int32_t>(32 * (0.45 * of(3) + 0.55 * of(4))));
      if (n >= (laps - 1) * lap && at > 40 && at < 360) {
        most = std::max(most, std::abs(wrong - learning.correction(n)));
      }
    }
    return most;
  }
};

}  // namespace

TEST_CASE("corrections become what an axis is off, from lap to lap") {
  Laps laps;
  CHECK(laps.largest(1, 0.5) > 80);
  CHECK(laps.largest(3, 0.5) < 60);
  CHECK(laps.largest(9, 0.5) < 12);
  CHECK(laps.largest(3, 1) < 12);
}

TEST_CASE("there are none at the ends of a lap, at rest, without room, or beyond 16 bits") {
  Points points;
  const auto run = [&](std::uint32_t lap, std::int32_t way, std::int32_t sum) {
    points.fill(0);
    Learning learning(&points, lap, 65536);
    for (std::uint32_t n = 0; n < 3 * lap + 6; ++n) learning.step(n, way, sum);
  };
  run(100, 512, 3200);
  for (std::uint32_t n = 0; n < 100; ++n) {
    CAPTURE(n);
    CHECK((points[n] != 0) == (n >= 12 && n < 88));
  }
  run(100, 511, 3200);
  for (const std::int16_t one : points) CHECK(one == 0);
  run(100, -512, 3200);
  CHECK(points[50] != 0);
  run(100, 512, 16777215);
  CHECK(points[50] == 32767);
  run(100, 512, -16777216);
  CHECK(points[50] == -32768);
  run(4097, 512, 3200);
  for (const std::int16_t one : points) CHECK(one == 0);
  CHECK(Learning().correction(5) == 0);
  Learning(nullptr, 100, 65536).step(50, 600, 3200);
}

TEST_CASE("a lap has corrections from its 13th point to the 13th from its end, no other") {
  for (const std::int32_t way : {Learning::kSlow, -Learning::kSlow}) {
    const Table table = learned(way);
    for (std::uint32_t at = 0; at < table.size(); ++at) {
      INFO("point " << at << ", way " << way);
      CHECK((table[at] != 0) == (at >= Learning::kEnds && at < kLap - Learning::kEnds));
    }
  }
}

TEST_CASE("an axis that is slow gets none") {
  for (const std::int32_t way : {Learning::kSlow - 1, 1 - Learning::kSlow, 0}) {
    CHECK(learned(way) == Table{});
  }
}
