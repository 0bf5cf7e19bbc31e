// SPDX-License-Identifier: Apache-2.0
//
// The eight experiments of Kung et al. on the fast plant of specification section 12: the exact
// twin must give the printed figures, to the printed digits.

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "models/exact/control/afc.hpp"
#include "models/ideal/fuzzy_controller.hpp"
#include "models/ideal/reference_model.hpp"

namespace {

using trammel::exact::Afc;

constexpr double kCount = 5e-6;  // [m]
const double kPi = std::acos(-1.0);

// One axis with a first-order current lag; semi-implicit Euler, no stops.
struct FastAxis {
  double mass;     // [kg] carried
  double coulomb;  // [N]
  double cogging;  // [N]
  double x = 0;    // [m]
  double v = 0;    // [m/s]
  double i_q = 0;  // [A]

  std::int32_t count() const { return static_cast<std::int32_t>(std::floor(x / kCount + 0.5)); }

  void sample(double i_q_ref) {
    constexpr double kStep = 62.5e-6;       // [s]
    constexpr double kLag = 0.2e-3;         // [s]
    constexpr double kForce = 79.9;         // [N/A]
    constexpr double kViscous = 20;         // [N s/m]
    constexpr double kSoft = 0.5e-3;        // [m/s]
    constexpr double kPolePitch = 30.5e-3;  // [m]
    const double gain = 1 - std::exp(-kStep / kLag);
    for (int n = 0; n < 8; ++n) {
      i_q += (i_q_ref - i_q) * gain;
      const double friction = coulomb * v / std::sqrt(v * v + kSoft * kSoft);
      const double cog = cogging * std::sin(2 * kPi * x / kPolePitch);
      v += kStep * (kForce * i_q - kViscous * v - friction - cog) / mass;
      x += kStep * v;
    }
  }
};

FastAxis x_axis(double payload, double cogging = 0) { return {2.5 + payload, 3.0, cogging}; }
FastAxis y_axis(double payload, double cogging = 0) { return {8.0 + payload, 4.8, cogging}; }

double amperes(double i_q_ref) { return i_q_ref * 4.8 / 2048; }

Afc::Config adaptive(bool on) {
  Afc::Config config;
  if (!on) config.eta.mant = 0;
  return config;
}

// ---- step test ----

struct Period {
  double overshoot = 0;  // [%] of the worse half
  double rms = 0;        // [mm] of model minus true position, of the worse half
};

struct StepTest {
  std::vector<Period> periods;
  double peak_current = 0;  // [A]
};

// Controller: std::int32_t i_q_ref and the unrounded model position [counts] from (r, count).
template <class Control>
StepTest step_test(FastAxis axis, Control control) {
  constexpr int kPeriods = 8;
  constexpr int kHalf = 750;
  constexpr double kSize = 2000;  // [counts]
  StepTest test;
  for (int period = 0; period < kPeriods; ++period) {
    Period worse;
    for (const double target : {kSize, 0.0}) {
      const double direction = target > 0 ? 1 : -1;
      double past = 0;
      double squares = 0;
      for (int n = 0; n < kHalf; ++n) {
        const auto [i_q_ref, x_m] = control(static_cast<std::int32_t>(target), axis.count());
        past = std::max(past, direction * (axis.x / kCount - target));
        squares += std::pow(1e3 * (x_m * kCount - axis.x), 2);
        axis.sample(amperes(i_q_ref));
        test.peak_current = std::max(test.peak_current, std::fabs(axis.i_q));
      }
      worse.overshoot = std::max(worse.overshoot, 100 * past / kSize);
      worse.rms = std::max(worse.rms, std::sqrt(squares / kHalf));
    }
    test.periods.push_back(worse);
  }
  return test;
}

StepTest exact_step_test(const FastAxis& axis, bool adapt) {
  Afc afc;
  const Afc::Config config = adaptive(adapt);
  return step_test(axis, [&](std::int32_t r, std::int32_t count) {
    const Afc::Out out = afc.step(config, {r, count});
    return std::pair<double, double>{out.i_q_ref, out.x_m / 16384.0};
  });
}

// ---- tracking ----

struct Point {
  double x, y;  // [mm]
};
using Points = std::vector<Point>;

Points circle() {
  Points points;
  for (int n = 0; n <= 628; ++n) {
    const double theta = 2 * kPi * n / 628;
    points.push_back({250 + 100 * std::sin(theta), 250 + 100 * std::cos(theta)});
  }
  return points;
}

void line(Points& points, int ticks, double dx, double dy) {
  const Point from = points.back();
  for (int n = 1; n <= ticks; ++n) points.push_back({from.x + n * dx, from.y + n * dy});
}

// Around a corner centre; theta of Kung's figures: x = cos, y = sin.
void arc(Points& points, double x, double y, double from) {
  for (int n = 1; n <= 67; ++n) {
    const double theta = from + kPi / 2 * n / 67;
    points.push_back({x + 30 * std::cos(theta), y + 30 * std::sin(theta)});
  }
}

Points window() {
  constexpr double kFeed = 0.7;  // [mm] per tick
  Points points{{150, 250}};
  line(points, 100, 0, kFeed);
  arc(points, 150, 350, 1.5 * kPi);
  line(points, 200, kFeed, 0);
  arc(points, 350, 350, kPi);
  line(points, 200, 0, -kFeed);
  arc(points, 350, 150, 0.5 * kPi);
  line(points, 200, -kFeed, 0);
  arc(points, 150, 150, 0);
  line(points, 100, 0, kFeed);
  return points;
}

Points star() {
  constexpr double kFeed = 100.0 / 182;  // [mm] per tick
  Points points{{200, 266.25}};
  for (const double degrees : {0.0, 216.0, 72.0, 288.0, 144.0}) {
    const double theta = degrees * kPi / 180;
    line(points, 182, kFeed * std::cos(theta), kFeed * std::sin(theta));
  }
  return points;
}

struct Indices {
  double mean = 0;      // [mm]
  double variance = 0;  // [mm^2]
};

std::int32_t counts(double mm) { return static_cast<std::int32_t>(std::lround(mm * 200)); }

Indices track(const Points& points, const Afc::Config& config, double cogging = 0) {
  std::array<FastAxis, 2> axis{x_axis(0, cogging), y_axis(0, cogging)};
  std::array<Afc, 2> afc;
  const auto command = [&](const Point& p) {
    return std::array<std::int32_t, 2>{counts(p.x), counts(p.y)};
  };
  const auto start = command(points.front());
  for (std::size_t a = 0; a < 2; ++a) {
    axis[a].x = start[a] * kCount;
    afc[a].reset(start[a]);
  }
  std::vector<double> errors;
  for (const Point& point : points) {
    const auto r = command(point);
    for (int hold = 0; hold < 4; ++hold) {
      std::array<double, 2> error{};
      for (std::size_t a = 0; a < 2; ++a) {
        const Afc::Out out = afc[a].step(config, {r[a], axis[a].count()});
        error[a] = 1e3 * (out.x_m / 16384.0 * kCount - axis[a].x);
        axis[a].sample(amperes(out.i_q_ref));
      }
      errors.push_back(std::hypot(error[0], error[1]));
    }
  }
  Indices indices;
  const auto n = static_cast<double>(errors.size());
  for (const double e : errors) indices.mean += e / n;
  for (const double e : errors) indices.variance += std::pow(e - indices.mean, 2) / n;
  return indices;
}

// Half a unit of the last printed digit, and a little for the binary fraction.
auto printed(double value, int digits) {
  return Approx(value).margin(0.5001 * std::pow(10.0, -digits)).epsilon(0);
}

}  // namespace

TEST_CASE("Step test with 11 kg gives the printed overshoots") {
  const StepTest fc_x = exact_step_test(x_axis(11), false);
  const StepTest fc_y = exact_step_test(y_axis(11), false);
  CHECK(fc_x.periods.front().overshoot == printed(12.8, 1));
  CHECK(fc_x.periods.back().overshoot == printed(12.8, 1));
  CHECK(fc_y.periods.front().overshoot == printed(23.1, 1));
  CHECK(fc_y.periods.back().overshoot == printed(22.8, 1));

  const StepTest afc_x = exact_step_test(x_axis(11), true);
  const StepTest afc_y = exact_step_test(y_axis(11), true);
  const std::array<double, 4> kX{12.7, 6.7, 3.1, 1.2};
  const std::array<double, 4> kY{23.5, 14.2, 9.1, 5.1};
  for (std::size_t period = 0; period < 4; ++period) {
    CAPTURE(period);
    CHECK(afc_x.periods[period].overshoot == printed(kX[period], 1));
    CHECK(afc_y.periods[period].overshoot == printed(kY[period], 1));
  }
  CHECK(afc_x.periods.back().overshoot == printed(1.16, 2));
  CHECK(afc_y.periods.back().overshoot == printed(4.04, 2));
  CHECK(afc_x.periods.front().rms == printed(1.15, 2));
  CHECK(afc_x.periods.back().rms == printed(0.61, 2));
  CHECK(afc_y.periods.front().rms == printed(1.57, 2));
  CHECK(afc_y.periods.back().rms == printed(0.72, 2));
  for (const StepTest* test : {&afc_x, &afc_y}) {
    for (std::size_t period = 1; period < 8; ++period) {
      CAPTURE(period);
      CHECK(test->periods[period].rms < test->periods[period - 1].rms);
    }
  }
  for (std::size_t period = 0; period < 8; ++period) {
    CHECK(afc_x.periods[period].overshoot < afc_y.periods[period].overshoot);
  }
  CHECK(std::max(afc_x.peak_current, afc_y.peak_current) == printed(1.4, 1));
}

TEST_CASE("Without payload the fuzzy controller overshoots by the printed little") {
  CHECK(exact_step_test(x_axis(0), false).periods.front().overshoot == printed(4.7, 1));
  CHECK(exact_step_test(y_axis(0), false).periods.front().overshoot == printed(5.3, 1));
}

TEST_CASE("Tracking gives the printed means and spreads") {
  const std::array<Points, 3> paths{circle(), window(), star()};
  REQUIRE(paths[0].size() == 629);
  REQUIRE(paths[1].size() == 1069);
  REQUIRE(paths[2].size() == 911);
  const std::array<double, 3> kFcMean{3.13, 1.52, 1.74};
  const std::array<double, 3> kAfcMean{2.11, 1.13, 1.38};
  const std::array<double, 3> kAfcMean3{2.111, 1.127, 1.383};  // section 13
  const std::array<double, 3> kFcVariance{0.40, 1.60, 3.49};
  const std::array<double, 3> kAfcVariance{0.44, 0.87, 2.43};
  const std::array<double, 3> kFcStd{0.63, 1.26, 1.87};
  const std::array<double, 3> kAfcStd{0.66, 0.93, 1.56};
  std::array<Indices, 3> fc, afc;
  for (std::size_t n = 0; n < 3; ++n) {
    CAPTURE(n);
    fc[n] = track(paths[n], adaptive(false));
    afc[n] = track(paths[n], adaptive(true));
    CHECK(fc[n].mean == printed(kFcMean[n], 2));
    CHECK(afc[n].mean == printed(kAfcMean[n], 2));
    CHECK(afc[n].mean == printed(kAfcMean3[n], 3));
    CHECK(fc[n].variance == printed(kFcVariance[n], 2));
    CHECK(afc[n].variance == printed(kAfcVariance[n], 2));
    CHECK(std::sqrt(fc[n].variance) == printed(kFcStd[n], 2));
    CHECK(std::sqrt(afc[n].variance) == printed(kAfcStd[n], 2));
    CHECK(afc[n].mean < fc[n].mean);
  }
  for (const std::size_t n : {1U, 2U}) CHECK(afc[n].variance < fc[n].variance);
  for (const auto& set : {fc, afc}) {
    CHECK(set[0].mean > set[2].mean);
    CHECK(set[2].mean > set[1].mean);
  }
}

TEST_CASE("Velocity feed-forward with 1 N of cogging gives the printed means") {
  const std::array<Points, 3> paths{circle(), window(), star()};
  const std::array<double, 3> kWithout{3.14, 1.52, 1.74};
  const std::array<double, 3> kWith{0.26, 0.37, 0.29};
  Afc::Config config = adaptive(false);
  for (std::size_t n = 0; n < 3; ++n) {
    CAPTURE(n);
    config.feedforward = false;
    CHECK(track(paths[n], config, 1).mean == printed(kWithout[n], 2));
    config.feedforward = true;
    CHECK(track(paths[n], config, 1).mean == printed(kWith[n], 2));
  }
}

TEST_CASE("Fixed-point words lose almost nothing against double precision") {
  // Periods 1 to 8, both axes: the grain of 5 um counts is 0.05 % of the step.
  for (const FastAxis& axis : {x_axis(11), y_axis(11)}) {
    trammel::ideal::ReferenceModel model;
    trammel::ideal::FuzzyController controller;
    const StepTest ideal = step_test(axis, [&](std::int32_t r, std::int32_t count) {
      const double x_m = model.step(r);
      const double i_q_ref = controller.step({}, x_m, count).i_q_ref;
      return std::pair<double, double>{i_q_ref, x_m};
    });
    const StepTest exact = exact_step_test(axis, true);
    for (std::size_t period = 0; period < 8; ++period) {
      CAPTURE(period);
      CHECK(exact.periods[period].overshoot ==
            Approx(ideal.periods[period].overshoot).margin(0.5).epsilon(0));
      CHECK(exact.periods[period].rms == Approx(ideal.periods[period].rms).margin(0.02).epsilon(0));
    }
  }
}

// ---- reference model ----

// Kung eq. 21, 23
TEST_CASE("Coefficients of the reference model are those printed, and their words follow") {
  const auto c = trammel::ideal::ReferenceModel::coefficients({});
  CHECK(c.a0 == Approx(5.54156481e-5).epsilon(1e-9));
  CHECK(c.a1 == Approx(1.10831296e-4).epsilon(1e-8));
  CHECK(c.a2 == c.a0);
  CHECK(c.b1 == Approx(-1.970223325062).epsilon(1e-12));
  CHECK(c.b2 == Approx(0.970444987655).epsilon(1e-12));
  CHECK(std::lround(c.a0 * std::pow(2, 32)) == Afc::Config{}.a0);
  CHECK(std::lround(c.b2 * std::pow(2, 23)) == Afc::Config{}.b2);
}

TEST_CASE("The incremental model follows the double-precision one and settles exactly") {
  Afc afc;
  trammel::ideal::ReferenceModel model;
  int reached = -1;
  double worst = 0;
  for (int k = 0; k < 4000; ++k) {
    const Afc::Out out = afc.step({}, {2000, 0});
    const double ideal = model.step(2000);
    worst = std::max(worst, std::fabs(out.x_m / 16384.0 - ideal));
    if (reached < 0 && out.x_m >= 0.9 * 2000 * 16384) reached = k;
    if (k >= 717) REQUIRE(out.x_r == 2000);
    if (k >= 2000) {
      REQUIRE(std::abs(out.dx) <= 16);
      REQUIRE(std::fabs(out.x_m / 16384.0 - 2000) <= 0.1495);
    }
  }
  CHECK(reached == 259);  // Kung eq. 22: 129.66 ms
  CHECK(worst < 0.25);  // [counts]
}

TEST_CASE("The model lags a ramp by two over omega_n") {
  Afc afc;
  std::int32_t r = 0;
  Afc::Out out;
  for (int k = 0; k < 2000; ++k) {
    r += 20;
    out = afc.step({}, {r, r});
  }
  CHECK((r - out.x_m / 16384.0) / 20 * 0.5 == Approx(2.0 / 30 * 1e3).margin(0.3));  // [ms]
}
