// SPDX-License-Identifier: Apache-2.0
//
// The estimator of mass, friction, cogging and force: the vectors of the specification, its
// equations in wide integers and in double precision, and words at the ends of their ranges.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <random>

#include "sw_nios/apps/kung/estimator.hpp"
#include "sw_nios/apps/kung/identification.hpp"

namespace {

using namespace trammel::sw;
using Theta = Estimator::Theta;
__extension__ using Wide = __int128;

constexpr std::int32_t kStart = 12800000;

// Section 8.3 of the specification in integers that nothing overflows, and the same in double
// precision without any rounding.
template <class Number>
struct Reference {
  static constexpr bool kExact = !std::is_same_v<Number, double>;
  static constexpr std::array<int, 6> kR0{2048, 8192, 98304, 1572864, 1572864, 1024};

  EstimatorSetup s;
  std::array<std::array<Number, 6>, 6> r{};
  std::array<Number, 6> q{}, theta{}, first{};
  std::array<Number, 4> c{}, i{};
  std::array<Number, 3> y{};
  int sums = 0;
  bool learned = false;

  Reference(const EstimatorSetup& setup, std::int32_t point) : s(setup) {
    first = theta = {Number(s.mass), Number(s.viscous), Number(s.coulomb), 0, 0, 0};
    for (std::size_t k = 0; k < 6; ++k) {
      r[k][k] = kR0[k];
      q[k] = kR0[k] * theta[k];
    }
    c.fill(point);
  }

  static Number shifted(Number x, unsigned n) {
    if constexpr (kExact) {
      return (x + (Number(1) << (n - 1))) >> n;
    } else {
      return std::ldexp(x, -static_cast<int>(n));
    }
  }
  static Number between(Number x, Number low, Number high) {
    return x < low ? low : x > high ? high : x;
  }
  static Number saturated(Number x, int bits) {
    const Number top = Number((std::int64_t{1} << (bits - 1)) - 1);
    return between(x, -top - 1, top);
  }
  static Number ratio(Number a, Number b) {
    if constexpr (kExact) {
      const Number size = a < 0 ? -a : a;
      const Number whole = (2 * size + b) / (2 * b);
      return a < 0 ? -whole : whole;
    } else {
      return a / b;
    }
  }
  static Number sine(std::int64_t k) {
    const double angle = 2 * 3.14159265358979323846 * static_cast<double>(k) / 1024;
    return Number(kExact ? std::floor(1024 * std::sin(angle) + 0.5) : 1024 * std::sin(angle));
  }

  void step(Number err, Number iq) {
    const Number p = shifted(52360 * c[0] + 504680 * c[1] + 455576 * c[2] + 35960 * c[3], 15);
    y = {p - err, y[0], y[1]};
    i = {iq, i[0], i[1], i[2]};
    if (++sums < 5) return;
    const Number d0 = y[0] - y[1], d1 = y[1] - y[2];
    const auto size = [](Number x) { return x < 0 ? -x : x; };
    learned = size(d0) >= s.slowest && size(d1) >= s.slowest && (d0 > 0) == (d1 > 0);
    if (learned) {
      const auto both = [this](std::size_t k) { return 27 * i[k] + 5 * i[k + 1]; };
      const Number f = saturated(shifted(both(0) + 6 * both(1) + both(2), 6), 20);
      const auto h = static_cast<std::int64_t>(
          std::floor(static_cast<double>(y[1]) / static_cast<double>(s.pitch)));
      const std::array<Number, 6> phi{saturated(shifted(d0 - d1, s.accel_shift), 16),
                                      saturated(shifted(d0 + d1, s.speed_shift), 16),
                                      Number(d0 > 0 ? 1024 : -1024), sine(h), sine(h + 256), 1024};
      for (std::size_t a = 0; a < 6; ++a) {
        for (std::size_t b = 0; b < 6; ++b) {
          r[a][b] += phi[a] * phi[b] - shifted(r[a][b] - (a == b ? kR0[a] : 0), 10);
        }
        q[a] += phi[a] * f * 65536 - shifted(q[a] - kR0[a] * first[a], 10);
      }
    }
    const Number quarter = theta[0] / 4, cogging = 4 * first[2];
    const std::array<Number, 6> least{std::max<Number>(s.mass_min, theta[0] - quarter), 0, 0,
                                      -cogging, -cogging, -8388608};
    const std::array<Number, 6> most{std::min<Number>(s.mass_max, theta[0] + quarter),
                                     3 * first[1], cogging, cogging, cogging, 8388608};
    for (int sweep = 0; sweep < 2; ++sweep) {
      for (std::size_t a = 0; a < 6; ++a) {
        Number rest = q[a];
        for (std::size_t b = 0; b < 6; ++b) rest -= r[a][b] * theta[b];
        theta[a] = between(theta[a] + ratio(rest, r[a][a]), least[a], most[a]);
      }
    }
  }
  void command(Number point) { c = {point, c[0], c[1], c[2]}; }
};

using Exact = Reference<Wide>;

Theta words(const Exact& exact) {
  Theta all{};
  for (std::uint32_t k = 0; k < 6; ++k) all[k] = static_cast<std::int32_t>(exact.theta[k]);
  return all;
}

std::int32_t wave(int n) {
  const auto point = static_cast<std::uint32_t>(n + 16);
  return n < 0 ? 0 : Identification::offset(16 + (point - 16) % 96, 40960);
}
int sign(std::int32_t x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

}  // namespace

TEST_CASE("an estimator that learns nothing more comes nearer to the solution, and stays") {
  // The identification move of a table whose friction is none, pulled by a force: Coulomb friction
  // and viscous friction end at their limits. What was cut only after the sweeps ran away.
  Estimator estimator({}, kStart);
  Exact exact({}, kStart);
  const auto cost = [&exact](const Theta& theta) {  // theta R theta / 2 - q theta
    long double sum = 0;
    for (std::size_t a = 0; a < 6; ++a) {
      for (std::size_t b = 0; b < 6; ++b) {
        sum += static_cast<long double>(exact.r[a][b]) * theta[a] * theta[b] / 2;
      }
      sum -= static_cast<long double>(exact.q[a]) * theta[a];
    }
    return sum;
  };
  Theta settled{};
  for (int n = 0; n < 6000; ++n) {
    const std::int32_t push = (n < 4 ? 0 : 4 * (wave(n - 1) - 2 * wave(n - 2) + wave(n - 3))) -
                              200 * sign(wave(n - 1) - wave(n - 2)) + 300;
    const long double before = cost(estimator.theta());
    estimator.step(0, n < 102 ? push : 0);
    exact.step(0, n < 102 ? push : 0);
    CAPTURE(n);
    REQUIRE(estimator.theta() == words(exact));
    if (n > 102) REQUIRE(cost(estimator.theta()) <= before * (1 + (before < 0 ? -1e-9L : 1e-9L)));
    estimator.command(kStart + (n < 96 ? wave(n) : wave(95)));
    exact.command(kStart + (n < 96 ? wave(n) : wave(95)));
    if (n == 4000) settled = estimator.theta();
  }
  CHECK(estimator.theta()[Estimator::kCoulomb] == 0);
  CHECK(estimator.theta() == settled);
}

TEST_CASE("on random ways and currents it is the specification's equations, bit for bit") {
  std::mt19937 random(7);
  const auto within = [&random](std::int32_t low, std::int32_t high) {
    return std::uniform_int_distribution<std::int32_t>(low, high)(random);
  };
  for (int run = 0; run < 40; ++run) {
    EstimatorSetup s;
    s.mass = within(1 << 12, 1 << 21);
    s.mass_min = s.mass / 3;
    s.mass_max = 4 * s.mass;
    s.viscous = within(0, 1 << 22);
    s.coulomb = within(0, 1 << 20);
    s.pitch = within(64, 1 << 20);
    s.accel_shift = static_cast<std::uint32_t>(within(1, 8));
    s.speed_shift = static_cast<std::uint32_t>(within(8, 16));
    s.slowest = within(1, 1 << 15);
    std::int32_t at = within(-60000, 60000) * 256, way = 0;
    Estimator estimator(s, at);
    Exact exact(s, at);
    const std::int32_t rough = 1 << within(6, 15), loud = 1 << within(4, 16);
    int learned = 0;
    for (int n = 0; n < 400; ++n) {
      way = std::clamp(way + within(-rough, rough), -131072, 131072);
      if (at + way > 131071 * 256 || at + way < -131071 * 256) way = -way;
      at += way;
      const std::int32_t err = within(-4000, 4000), iq = within(-loud, loud - 1);
      estimator.step(err, iq);
      exact.step(err, iq);
      CAPTURE(run, n);
      REQUIRE(estimator.theta() == words(exact));
      learned += exact.learned ? 1 : 0;
      estimator.command(at);
      exact.command(at);
    }
    CHECK(learned > 10);
  }
}

TEST_CASE("saturated currents and the fastest way change no bit either") {
  for (const std::int32_t push : {-65536, 65504}) {
    for (const std::int32_t turn : {5, 40, 1000}) {
      Estimator estimator({}, 0);
      Exact exact({}, 0);
      std::int32_t at = 0, way = 131072;
      for (int n = 0; n < 1500; ++n) {
        if (n % turn == 0) way = -way;
        at += (at > (1 << 24) && way > 0) || (at < -(1 << 24) && way < 0) ? way = -way : way;
        estimator.step(n % 7, n % 3 == 0 ? push : -push);
        exact.step(n % 7, n % 3 == 0 ? push : -push);
        CAPTURE(push, turn, n);
        REQUIRE(estimator.theta() == words(exact));
        estimator.command(at);
        exact.command(at);
      }
    }
  }
}

TEST_CASE("after ways beyond its 32-bit words it goes on in them, and no bit is lost") {
  Estimator estimator({}, 0);
  Exact exact({}, 0);
  std::int32_t at = 0, way = 131072;
  for (int n = 0; n < 9000; ++n) {
    if (n == 1500) way = 1000;  // what was learned at speed is forgotten
    if (n % 40 == 0) way = -way;
    at += way;
    estimator.step(n % 7, 300 * sign(way));
    exact.step(n % 7, 300 * sign(way));
    CAPTURE(n);
    REQUIRE(estimator.theta() == words(exact));
    estimator.command(at);
    exact.command(at);
  }
}

TEST_CASE("its roundings cost less than 0.1 % of the mass of double-precision least squares") {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 60);
  Estimator estimator({}, kStart);
  Reference<double> ideal({}, kStart);
  // 2.5 kg, 20 N s/m, 3 N on sines of 8 m/s^2; a sum of 32 i_q* has 5.34 LSB a newton each.
  double largest = 0;
  for (int n = 0; n < 800; ++n) {
    const double w = 2 * 3.14159265358979 * 6 * 2e-3;
    const auto x = [w](int k) { return 1.1e6 * (1 - std::cos(w * k)); };
    const double a = (x(n - 1) - 2 * x(n - 2) + x(n - 3)) / 256 * 5e-6 / 4e-6;
    const double v = (x(n - 1) - x(n - 3)) / 256 * 5e-6 / 4e-3;
    const double force = 2.5 * a + 20 * v + (v > 0 ? 3 : v < 0 ? -3 : 0);
    const auto push = static_cast<std::int32_t>(std::lround(32 * 5.34 * force + noise(random)));
    estimator.step(0, push);
    ideal.step(0, push);
    const auto point = static_cast<std::int32_t>(std::lround(x(n)));
    estimator.command(kStart + point);
    ideal.command(kStart + point);
    if (n > 100) {
      largest = std::max(largest, std::abs(estimator.theta()[0] / ideal.theta[0] - 1));
    }
  }
  CHECK(largest < 1e-3);
  CHECK(estimator.theta()[0] / 54681.6 == Approx(2.5).epsilon(0.03));
  CHECK(estimator.theta()[2] / 43745.3 == Approx(3).epsilon(0.2));
}

TEST_CASE("nothing is learned before five sums, at rest or where the way turns") {
  Estimator estimator({}, kStart);
  const Theta start = estimator.theta();
  for (int n = 0; n < 50; ++n) {
    estimator.step(n % 5, 30000);
    estimator.command(kStart + (n % 2 == 0 ? 300 : -300));
    CHECK(estimator.theta() == start);
  }
}

TEST_CASE("a mass beyond its range is held at the end of it, and said") {
  for (const std::int32_t heavy : {0, 1}) {
    EstimatorSetup s;
    Estimator estimator(s, 0);
    bool limit = false;
    std::int32_t way = 0, at = 0;
    for (int n = 0; n < 600; ++n) {
      const int phase = n % 60;
      way += phase < 15 || phase >= 45 ? 1600 : -1600;
      at += way;
      const std::int32_t a = phase < 15 || phase >= 45 ? 1 : -1;
      estimator.step(0, heavy != 0 ? 60000 * a : -2000 * a);
      limit = estimator.at_limit();
      estimator.command(at);
    }
    CHECK(limit);
    CHECK(estimator.theta()[0] == (heavy != 0 ? s.mass_max : s.mass_min));
  }
}
