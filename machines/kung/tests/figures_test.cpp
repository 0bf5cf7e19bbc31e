// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <string>

#include "lab/scenarios.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/judge/figures.hpp"
#include "tests/support/figures.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

constexpr double kPi = 3.14159265358979323846;

// A run whose model stands still and whose table is `offset` [m] away from it.
kung::Result offset_run(const std::vector<kung::PointM>& offset) {
  kung::Result result;
  result.first_tick = 10;
  result.points = static_cast<std::uint32_t>(offset.size());
  result.end_tick = 10 + result.points;
  for (std::size_t k = 0; k < offset.size() + 20; ++k) {
    kung::Sample s;
    s.tick = static_cast<std::uint32_t>(k);
    for (auto& axis : s.axis) {
      axis.r = 2000;
      axis.x_m = 2000 << 14;
    }
    const bool inside = k >= 10 && k < 10 + offset.size();
    s.axis[0].x_true_m = 0.01 - (inside ? offset[k - 10].x_m : 1.0);
    s.axis[1].x_true_m = 0.01 - (inside ? offset[k - 10].y_m : 1.0);
    result.samples.push_back(s);
  }
  return result;
}

// The value of each figure.
std::map<std::string, double> values(kung::Result& result, const kung::Options& options = {}) {
  std::map<std::string, double> all;
  for (const lab::Figure& f : figures(options, result)) all[f.id] = f.value;
  return all;
}

}  // namespace

// Kung eq. 44
TEST_CASE("equation 44 is the distance of model output and table") {
  CHECK(tracking_error({3e-3, 0}, {0, 4e-3}) == Approx(5e-3));
}

// Kung eq. 45, 46
TEST_CASE("equations 45 and 46 are the mean and the root of the mean squared deviation") {
  const Spread s = spread({1, 2, 3, 4, 10});
  CHECK(s.mean == Approx(4));
  CHECK(s.variance == Approx((9 + 4 + 1 + 0 + 36) / 5.0));  // by n, not n - 1
  CHECK(s.std == Approx(std::sqrt(10.0)));
  CHECK(s.rms == Approx(std::sqrt(130.0 / 5)));
  CHECK(s.max == 10);
  CHECK(spread({}).n == 0);
}

TEST_CASE("a run that ended early counts the samples it has") {
  auto result = offset_run({{3e-3, 4e-3}, {6e-3, 8e-3}});
  host::DiskVector<kung::Sample> eleven;
  for (std::size_t k = 0; k < 11; ++k) eleven.push_back(result.samples[k]);
  result.samples = std::move(eleven);
  result.end = kung::EndReason::kFault;
  CHECK(values(result).at("tracking.model.samples") == 1);
  result.points = 0;  // the path had not begun
  CHECK(values(result).at("tracking.model.samples") == 0);
  CHECK_FALSE(figures(kung::Options{}, result).front().shown);
  result.samples = {};
  CHECK(values(result).at("tracking.model.samples") == 0);
}

TEST_CASE("each lap of a path that repeats has figures of its own, the last with the last point") {
  kung::Options options;
  options.chip.irq_period_ticks = 1;
  options.path.repeats = 2;
  // Two laps of two points; the path ends with a fifth.
  auto result = offset_run({{3e-3, 4e-3}, {6e-3, 8e-3}, {1e-3, 0}, {1e-3, 0}, {0, 4e-3}});
  const auto m = values(result, options);
  CHECK(m.at("laps.0.model.mean_mm") == Approx(7.5));
  CHECK(m.at("laps.0.model.variance_mm2") == Approx(6.25));
  CHECK(m.at("laps.0.contour.mean_mm") == Approx(7.5));  // the command stands still, too
  CHECK(m.at("laps.1.model.mean_mm") == Approx(2));
  CHECK(m.at("laps.1.model.variance_mm2") == Approx(2));
  CHECK(m.count("laps.2.model.mean_mm") == 0);
  for (const lab::Figure& f : figures(options, result)) {
    if (f.id.rfind("laps.", 0) != 0) continue;
    INFO(f.id << ": " << f.row);
    CHECK(f.row.find(f.id[5] == '0' ? "lap 1" : "lap 2") != std::string::npos);
  }
  options.path.repeats = 1;
  CHECK(values(result, options).count("laps.0.model.mean_mm") == 0);
  options.path.repeats = 2;
  result.end = kung::EndReason::kMissed;
  CHECK(values(result, options).count("laps.0.model.mean_mm") == 0);
}

TEST_CASE("of many laps the first eight and the last are shown") {
  kung::Options options;
  options.chip.irq_period_ticks = 1;
  options.path.repeats = 20;
  auto result = offset_run(std::vector<kung::PointM>(21, {3e-3, 4e-3}));
  std::map<std::string, bool> shown;
  for (const lab::Figure& f : figures(options, result)) shown[f.id] = f.shown;
  CHECK(shown.at("laps.7.model.mean_mm"));
  CHECK_FALSE(shown.at("laps.8.model.mean_mm"));
  CHECK_FALSE(shown.at("laps.18.contour.mean_mm"));
  CHECK(shown.at("laps.19.model.mean_mm"));
}

TEST_CASE("only a complete run of the paper's experiment stands beside the paper's figures") {
  const auto settings = lab::load_scenario(lab::find_scenario("circle"));
  auto result = offset_run({{3e-3, 4e-3}, {6e-3, 8e-3}});
  CHECK(lab::any_expected(figures(*settings, result)));
  result.end = kung::EndReason::kFault;
  CHECK_FALSE(lab::any_expected(figures(*settings, result)));
}

TEST_CASE("the contour error of a lagging table on a circle is its radial error") {
  Points path, table;
  for (int k = 0; k < 2000; ++k) {
    const double angle = 2 * kPi * k / 2000;
    path.push_back({0.1 * std::sin(angle), 0.1 * std::cos(angle)});
    const double behind = angle - 0.3;
    table.push_back({0.097 * std::sin(behind), 0.097 * std::cos(behind)});
  }
  const auto errors = contour_error(table, path, 200);
  REQUIRE(errors.size() == 2000);
  // A chord of the polyline is 0.5 um inside the circle.
  for (std::size_t k = 100; k < 2000; ++k) CHECK(errors[k] == Approx(3e-3).margin(1e-6));
}

TEST_CASE("a crossing branch that is far away in time does not hide a contour error") {
  // Along y = 0, back at y = 5 mm much later; the table is 4 mm off on the first branch.
  Points path;
  for (int k = 0; k < 1000; ++k) path.push_back({k * 1e-3, 0});
  for (int k = 0; k < 1000; ++k) path.push_back({1 - k * 1e-3, 5e-3});
  const Points table{{0.0, 4e-3}};
  CHECK(contour_error(table, path, 100).front() == Approx(4e-3));
}

TEST_CASE("overshoot is the excursion past the target over the step, in both directions") {
  const Series model{0, 10e-3, 10e-3, 0, 0, 0, 10e-3, 10e-3, 10e-3, 0, 0, 0};
  // 12.8 % up at the second value, 20 % down at the fifth, 5 % up at the eighth.
  const Series position{0, 11.28e-3, 10e-3, 0, -2e-3, 0, 10e-3, 10.5e-3, 10e-3, 0, 0, 0};
  const auto halves = half_periods(position, model, 3, 0, 10e-3);
  REQUIRE(halves.size() == 4);
  CHECK(halves[0].overshoot_percent == Approx(12.8));
  CHECK(halves[0].rms_mm == Approx(1.28 / std::sqrt(3.0)));
  CHECK(halves[1].overshoot_percent == Approx(20));
  CHECK(halves[3].overshoot_percent == Approx(0).margin(1e-9));
  const auto both = periods(halves);
  REQUIRE(both.size() == 2);
  CHECK(both[0].overshoot_percent == Approx(20));
  CHECK(both[1].overshoot_percent == Approx(5));
  CHECK(periods({halves[0], halves[1], halves[2]}).size() == 1);  // whole ones alone
}

TEST_CASE("a downward first step is measured the same way") {
  const Series model{0, -10e-3, -10e-3};
  const Series position{0, -11e-3, -9e-3};
  CHECK(half_periods(position, model, 3, 0, -10e-3).front().overshoot_percent == Approx(10));
}

TEST_CASE("the signed contour error is positive on the left of the direction of travel") {
  Points path, table;
  for (int k = 0; k <= 100; ++k) {
    path.push_back({1e-3 * k, 0});
    table.push_back({1e-3 * k, k < 50 ? 2e-4 : -3e-4});
  }
  const Series errors = signed_contour_error(table, path, 20);
  for (std::size_t k = 0; k < 100; ++k) {
    CAPTURE(k);
    CHECK(errors[k] == Approx(k < 50 ? 2e-4 : -3e-4));
  }
}

TEST_CASE("a table that is nearest to the first point of its path is on one side of it too") {
  const Points path{{0, 0}, {0.01, 0}, {0.02, 0}};
  const Points left{{-0.003, 0.004}, {-0.003, 0.004}};
  const Points right{{-0.003, -0.004}, {-0.003, -0.004}};
  CHECK(signed_contour_error(left, path, 5)[1] == Approx(0.005));
  CHECK(signed_contour_error(right, path, 5)[1] == Approx(-0.005));
  CHECK(signed_contour_error(right, {{0, 0}}, 5)[1] == Approx(0.005));  // of a point it has no side
}

TEST_CASE("a table has settled once it stays within the band") {
  Points points;
  for (const double x : {5.0, 2.0, 0.5, -1.5, 0.9, 0.2, 0.0}) points.push_back({x * 1e-3, 0});
  CHECK(settled_after(points, {0, 0}, 1e-3) == 4);
  CHECK(settled_after(points, {0, 0}, 10e-3) == 0);
  CHECK(settled_after(points, {1, 0}, 1e-3) == 7);
}

TEST_CASE("each column of the trace shows the word or the truth that it is named after") {
  kung::Result result;
  kung::Sample s;
  s.tick = 3;
  s.edge = 150'000;
  std::map<std::string, double> expected{{"tick", 3}, {"t_s", 3e-3}};
  for (std::size_t a = 0; a < 2; ++a) {
    AxisSample& at = s.axis[a];
    int n = a == 0 ? 100 : 200;  // each value once
    const std::string axis = a == 0 ? "x_" : "y_";
    const auto put = [&](const char* name, auto& member, double unit = 1) {
      member = ++n;
      expected[axis + name] = n * unit;
    };
    put("command_m", at.r, 5e-6);
    put("model_m", at.x_m, 5e-6 / 16384);
    put("encoder_count", at.x_p);
    put("e", at.e);
    put("de", at.de);
    put("u", at.u);
    put("v_star", at.v_star);
    put("v", at.v);
    put("i_q_ref", at.i_q_ref);
    put("i_d", at.i_d);
    put("i_q", at.i_q);
    put("v_d", at.v_d);
    put("v_q", at.v_q);
    put("position_m", at.x_true_m);
    put("v_m_s", at.v_true_m_s);
    put("i_d_A", at.i_d_true_A);
    put("i_q_A", at.i_q_true_A);
    put("force_N", at.force_N);
  }
  result.samples.push_back(s);
  test::check_row(test::row(kung::Options{}, result, 0), expected);
}
