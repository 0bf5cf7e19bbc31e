// SPDX-License-Identifier: Apache-2.0
//
// The law of the precision controller in double precision, and the normal equations of its
// estimator.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "models/exact/control/precision.hpp"
#include "models/ideal/normal_equations.hpp"
#include "models/ideal/precision.hpp"

using namespace trammel::ideal;

namespace {

using trammel::exact::PrecisionStore;
using trammel::fixed::Gain;
using Ideal = trammel::ideal::Precision;
using Twin = trammel::exact::Precision;
using Word = PrecisionStore::Word;

// The nearest mantissa, 1024 to 2047.
Gain nearest(double value) {
  if (value < 1e-9) return {};
  int exp = 0;
  const double mant = std::frexp(value, &exp);
  const auto rounded = static_cast<std::int32_t>(std::lround(mant * 2048));
  return rounded == 2048 ? Gain{1024, exp + 1} : Gain{rounded, exp};
}

std::int32_t word(const Gain& g) { return g.mant | ((g.exp & 31) << 16); }
std::int32_t word(double value) { return word(nearest(value)); }

void require_gain(double value, int mant, int exp) {
  CAPTURE(value);
  REQUIRE(nearest(value).mant == mant);
  REQUIRE(nearest(value).exp == exp);
}

// A mass with friction behind a current that acts one tick late.
struct Mass {
  double x = 0, v = 0, i_q = 0;  // [count], per tick, LSB
  double mass = 0, viscous = 0;  // [kg], [N s/m]

  void move(double next) {
    const double a = (i_q - Ideal::kPerViscous * viscous * v) / (Ideal::kPerMass * mass);
    x += v + a / 2;
    v += a;
    i_q = next;
  }
};

// 100 mm/s^2-like points: rest, a sine of 400 counts, rest.
std::vector<double> points() {
  std::vector<double> c(6, 2000.0);
  for (int n = 0; n < 200; ++n) c.push_back(2000 + 200 * (1 - std::cos(0.0628318530717958 * n)));
  c.insert(c.end(), 30, c.back());
  for (double& p : c) p = std::round(p * 256) / 256;
  return c;
}

}  // namespace

// Section 5
TEST_CASE("The gains of both sets of poles are those of the specification") {
  const Ideal::Gains full = Ideal::gains({300, 0.7, 4000, 400});
  require_gain(full.l1, 1673, -1);
  require_gain(full.l2, 1882, -4);
  require_gain(full.l3, 1267, -9);
  require_gain(full.k1, 1475, -11);
  require_gain(full.k2, 1720, -5);
  const Ideal::Gains soft = Ideal::gains({120, 0.7, 1500, 0});
  require_gain(soft.l1, 1401, -2);
  require_gain(soft.l2, 1050, -6);
  require_gain(soft.l3, 0, 0);
  require_gain(soft.k1, 1887, -14);
  require_gain(soft.k2, 1376, -6);
}

// Section 10
TEST_CASE("The words of mass and friction are those of the specification") {
  const auto km = [](double kg) { return Ideal::kPerMass * kg / (1 << 18); };
  require_gain(km(2.5), 1068, -3);
  require_gain(1 / km(2.5), 1964, 4);
  require_gain(km(8), 1709, -2);
  require_gain(km(13.5), 1442, -1);
  require_gain(km(25), 1335, 0);
  require_gain(1 / km(25), 1571, 1);
  require_gain(km(30.5), 1629, 0);
  require_gain(Ideal::kPerViscous * 20 / (1 << 6), 1094, -2);
}

TEST_CASE("The point of a knot is the set point 62 ticks after it") {
  const std::vector<double> step{0, 0, 1, 1, 1, 1, 1};
  REQUIRE(Ideal::set_point(step, 63).p == 0);
  // Half way between the two points: 16 ticks before the second.
  REQUIRE(Ideal::set_point(step, 64 + 62).p + Ideal::set_point(step, 64 + 30).p == Approx(1));
  REQUIRE(Ideal::set_point(step, 64 + 127).p == Approx(1));
  // A ramp: the set point lags by 62 ticks exactly.
  std::vector<double> ramp;
  for (int k = 0; k < 10; ++k) ramp.push_back(320 * k);
  const Ideal::Point s = Ideal::set_point(ramp, 250);
  REQUIRE(s.p == Approx(10 * (250 - Ideal::kDelay)));
  REQUIRE(s.v == Approx(10));
  REQUIRE(std::abs(s.a) < 1e-9);
}

TEST_CASE("The twin of the law follows the ideal one within what the count leaves open") {
  const double mass = 7.9, viscous = 20;
  Ideal::Config config;
  config.mass = mass;
  config.viscous = viscous;
  config.coulomb = 0;
  config.lead = 1;
  PrecisionStore window;
  const auto write = [&](Word w, std::int32_t value) {
    window.write(0, static_cast<int>(w), value);
  };
  write(Word::kL1, word(config.gains.l1));
  write(Word::kL2, word(config.gains.l2));
  write(Word::kL3, word(config.gains.l3));
  write(Word::kK1, word(config.gains.k1));
  write(Word::kK2, word(config.gains.k2));
  const double km = Ideal::kPerMass * mass / (1 << 18);
  write(Word::kKm, word(km));
  write(Word::kKmi, word(1 / km));
  write(Word::kKb, word(Ideal::kPerViscous * viscous / (1 << 6)));
  write(Word::kMisc, 1 | 4 << 4);  // LEAD, KNEE; no edge times, no rest rule
  const std::vector<double> c = points();
  Mass exact{2000.4, 0, 0, mass, viscous}, ideal = exact;
  Twin twin;
  Twin::In in;
  in.count = 2000;
  in.reset = true;
  twin.step(in, window, 0);
  in.reset = false;
  Ideal::State state;
  state.e1 = -0.4;
  double widest = 0, apart = 0, set = 0;
  for (int t = 0; t < static_cast<int>(c.size()) * 32; ++t) {
    const auto k = static_cast<std::size_t>(t / 32);
    in.knot = t % 32 == 0 ? Twin::Knot::kCommit : Twin::Knot::kNone;
    write(Word::kC, static_cast<std::int32_t>(256 * c[k]));
    in.count = static_cast<std::int32_t>(std::floor(exact.x));
    const Twin::Out out = twin.step(in, window, 0);
    // The count is half a count low on average.
    const double i_q = Ideal::step(config, state, Ideal::set_point(c, t), ideal.x - 0.5);
    set = std::max(set, std::abs(static_cast<double>(twin.state().p) / (1 << 23) -
                                 Ideal::set_point(c, t).p));
    exact.move(out.i_q_ref);
    ideal.move(i_q);
    if (t < 2000) continue;  // both begin 0.1 counts from rest
    widest = std::max(widest, std::abs(state.e));
    apart = std::max(apart, std::abs(exact.x - ideal.x));
  }
  CAPTURE(set, widest, apart);
  REQUIRE(set < 1e-6);  // the spline is exact; the ideal one sums in double precision
  // Without friction the feed-forward is all: gains of 11 bits are off by 2.5e-4 at most.
  REQUIRE(widest < 0.05);
  // The limit cycle of a count: it stays inside one, the ideal does not have it.
  REQUIRE(apart < 1.0);
}

TEST_CASE("regressors without a common part are known apart, by their own squares") {
  const auto known = knowledge_of<3>({{{4, 0, 0}, {0, 25, 0}, {0, 0, 0.01}}});
  CHECK(known.variance[0] == Approx(0.25));
  CHECK(known.variance[1] == Approx(0.04));
  CHECK(known.variance[2] == Approx(100));
  for (const double share : known.own_share) CHECK(share == Approx(1));
}

TEST_CASE("the variance is the spread of least-squares estimates, the share the sine squared") {
  // Two regressors at 30 degrees to each other, in ten thousand fits of 50 noisy samples.
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::array<std::array<double, 2>, 50> phi{};
  std::array<std::array<double, 2>, 2> r{};
  for (auto& p : phi) {
    p[0] = normal(random);
    p[1] = std::cos(0.5235987756) * p[0] + std::sin(0.5235987756) * normal(random);
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) r[i][j] += p[i] * p[j];
    }
  }
  const auto known = knowledge_of(r);
  double squares = 0;
  constexpr int kFits = 10000;
  for (int fit = 0; fit < kFits; ++fit) {
    std::array<double, 2> q{};
    for (const auto& p : phi) {
      const double noise = normal(random);
      for (std::size_t i = 0; i < 2; ++i) q[i] += p[i] * noise;
    }
    const double off = (r[1][1] * q[0] - r[0][1] * q[1]) / (r[0][0] * r[1][1] - r[0][1] * r[1][0]);
    squares += off * off;
  }
  CHECK(squares / kFits == Approx(known.variance[0]).epsilon(0.06));  // four of its deviations
  const double cosine2 = r[0][1] * r[0][1] / (r[0][0] * r[1][1]);
  CHECK(known.own_share[0] == Approx(1 - cosine2));
  CHECK(known.own_share[1] == Approx(1 - cosine2));
}
