// SPDX-License-Identifier: Apache-2.0
//
// The path that was asked, and how far from it a table is that follows it.
#include <catch2/catch.hpp>
#include <cmath>

#include "machines/kung/chip/record.hpp"
#include "machines/kung/judge/figures.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/run/commanded_path.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "machines/kung/run/outcome.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

constexpr double kCountM = 5e-6;

// A line of 30 x 40 mm, whose limit is a twentieth of its 50 mm.
Options line() {
  Options options;
  options.path.kind = PathKind::kLine;
  options.path.line_start_x_m = options.path.line_start_y_m = 0.1;
  options.path.line_end_x_m = 0.13;
  options.path.line_end_y_m = 0.14;
  return options;
}

struct Judge {
  explicit Judge(const Options& options) : outcome(*make_plan(options)) {}

  std::string missed(std::uint32_t handed = 501) const {
    return outcome.missed(handed, 501, {0.13, 0.14}, lagging);
  }

  Outcome outcome;
  PointM lagging{0.13, 0.14};
};

CommandedPath commanded_line() {
  Options options;
  options.path.kind = PathKind::kLine;
  options.path.line_start_x_m = options.path.line_start_y_m = 0.1;
  options.path.line_end_x_m = 0.2;
  options.path.line_end_y_m = 0.1;
  options.path.line_ticks = 100;
  return {sw::Trajectory(make_plan(options)->setup), 4, 5e-6, 500};
}

}  // namespace

TEST_CASE("a table that goes along the path to its end has followed it") {
  Judge judge(line());
  CHECK(judge.outcome.limit_m() == Approx(0.0025));
  for (int k = 0; k <= 40; ++k) judge.outcome.add({0.1 + 0.00075 * k, 0.1 + 0.001 * k}, 1e-3);
  CHECK(judge.missed() == "");
  CHECK(judge.outcome.from_m({0.13, 0.14}) == Approx(0).margin(1e-9));
  CHECK(judge.missed(480) == "stopped after 480 of 501 points");
}

TEST_CASE("a table that is not at the end, beside the path, or went only a part has missed it") {
  const std::string above = " above 2.5 mm (run.reached_m)";
  Judge stands(line());
  stands.outcome.add({0.1, 0.1}, 0);
  CHECK(stands.missed() == "the table ended 50.00 mm from the last of 501 points," + above +
                               "; run.settle_s gives it time");
  Judge beside(line());
  beside.outcome.add({0.1, 0.1}, 0.0026);
  beside.outcome.add({0.13, 0.14}, 0);
  CHECK(beside.missed() == "the table was 2.60 mm beside the path asked," + above);
  Judge waits(line());  // near the end all the time, as on a path that comes by it often
  waits.outcome.add({0.129, 0.139}, 0);
  waits.outcome.add({0.13, 0.14}, 0);
  CHECK(waits.missed() ==
        "the table covered 1.00 x 1.00 mm of a path of 30.00 x 40.00 mm," + above);
  // Each side of the path by itself; the last point is at its middle.
  for (const char* side : {"low x", "low y", "high x", "high y"}) {
    CAPTURE(side);
    const std::string which = side;
    Judge judge(line());
    judge.outcome.add({which == "low x" ? 0.115 : 0.1, which == "low y" ? 0.12 : 0.1}, 0);
    judge.outcome.add({which == "high x" ? 0.115 : 0.13, which == "high y" ? 0.12 : 0.14}, 0);
    judge.outcome.add({0.115, 0.12}, 0);
    CHECK_THAT(judge.outcome.missed(501, 501, {0.115, 0.12}, {0.115, 0.12}),
               Catch::StartsWith("the table covered "));
  }
}

TEST_CASE("each side of a path whose axes lie apart is judged in its own axis") {
  Options options = line();
  options.path.line_start_x_m = 0.05;
  options.path.line_end_x_m = 0.08;
  options.path.line_start_y_m = 0.24;  // down
  options.path.line_end_y_m = 0.20;
  const struct {
    const char* name;
    double low_x, high_x, low_y, high_y;
    bool followed;
  } tables[] = {{"all of it", 0.05, 0.08, 0.20, 0.24, true},
                {"2.4 mm short on each side", 0.0524, 0.0776, 0.2024, 0.2376, true},
                {"short of low x", 0.0526, 0.08, 0.20, 0.24, false},
                {"short of high x", 0.05, 0.0774, 0.20, 0.24, false},
                {"short of low y", 0.05, 0.08, 0.2026, 0.24, false},
                {"short of high y", 0.05, 0.08, 0.20, 0.2374, false}};
  for (const auto& table : tables) {
    Judge judge(options);
    judge.outcome.add({table.low_x, table.high_y}, 0);
    judge.outcome.add({table.high_x, table.low_y}, 0);
    judge.outcome.add({0.065, 0.22}, 0);
    const std::string what = judge.outcome.missed(501, 501, {0.065, 0.22}, {0.065, 0.22});
    INFO("a table that covers " << table.name << ": " << what);
    CHECK(what.empty() == table.followed);
    if (!table.followed) {
      CHECK_THAT(what, Catch::Contains("of a path of 30.00 x 40.00 mm"));
    }
  }
}

TEST_CASE("the limit is run.reached_m, or lies between 3 counts and run.diverged_m") {
  Options options = line();
  options.reached_m = 0.002;
  CHECK(Judge(options).outcome.limit_m() == 0.002);
  options = line();
  options.diverged_m = 0.001;
  CHECK(Judge(options).outcome.limit_m() == 0.001);
  options = line();
  options.path.line_end_x_m = options.path.line_end_y_m = 0.10001;
  CHECK(Judge(options).outcome.limit_m() == Approx(3 * kCountM));
}

TEST_CASE("the precision controller is judged by its promise: 15 um or 3 counts to the command") {
  const auto judge = [](auto change, const PathFile& file = {}) {
    Options options = line();
    options.controller = Controller::kPrecision;
    change(options);
    Outcome outcome(*make_plan(options, file));
    outcome.add({0.1, 0.1}, 0);
    outcome.add({0.13, 0.14}, 0);
    return outcome;
  };
  const auto counts = [](double count_m) {
    return [count_m](Options& o) {
      for (plant::AxisConfig& axis : o.plant.axis) axis.encoder_count_m = count_m;
      for (AxisChip& axis : o.chip.axis) axis.stroke_max_m = 0.25;
    };
  };
  CHECK(judge(counts(5e-6)).promised_m() == Approx(15e-6));
  CHECK(judge(counts(2e-6)).promised_m() == Approx(15e-6));
  CHECK(judge(counts(10e-6)).promised_m() == Approx(30e-6));
  CHECK(judge([](Options& o) { o.reached_m = 40e-6; }).promised_m() == 40e-6);
  CHECK(judge([](Options& o) {
          o.controller = Controller::kAfc;
          o.path.profile = Profile::kFeed;
        }).promised_m() == 0);
  // Points with their own times, of which the reader of the file warned that no axis follows them.
  const auto timed = [](Options& o) { o.path.kind = PathKind::kPoints; };
  PathFile file;
  file.points = {{0.1, 0.1}, {0.1, 0.1001}};
  CHECK(judge(timed, file).promised_m() == Approx(15e-6));
  file.warnings = {"a.csv:2: 10 mm of X"};
  CHECK(judge(timed, file).promised_m() == 0);

  const PointM last{0.13, 0.14};
  const auto missed = [&](double error_m, const PointM& end, auto change) {
    return judge(change).missed(501, 501, end, end, error_m);
  };
  const auto plain = counts(5e-6);
  CHECK(missed(14.9e-6, last, plain) == "");
  CHECK(missed(88.94e-6, last, plain) ==
        "the table was 88.9 um from its command, above 15 um (run.reached_m)");
  CHECK(missed(0.0147, last, plain) ==
        "the table was 14.70 mm from its command, above 15 um (run.reached_m)");
  CHECK(missed(0.0147, last, [](Options& o) { o.reached_m = 0.02; }) == "");
  CHECK_THAT(missed(0, {0.13 - 21e-6, 0.14}, plain),
             Catch::Contains("the table ended 21.0 um from the last of 501 points, above 15 um "));
}

TEST_CASE("a square wave is overshot by up to a quarter, as by the paper's table") {
  Options options;
  options.path.kind = PathKind::kSquare;  // of 10 mm
  CHECK(Judge(options).outcome.limit_m() == Approx(std::hypot(0.01, 0.01) / 4));
}

TEST_CASE("a model that is far too slow for its circle has not followed it") {
  Options options;
  options.run.engine = Engine::kTwin;
  for (AxisGains& gains : options.gains) gains.omega_n_rad_s = 8;
  const Result result = simulate(options, {});
  CHECK(result.end == EndReason::kMissed);
  CHECK(result.missed.find("mm beside the path asked, above 14.14 mm (run.reached_m)") !=
        std::string::npos);
}

TEST_CASE("a table may lag at the end of a fast path as the model does, by half at most") {
  Judge judge(line());
  for (int k = 0; k <= 30; ++k) judge.outcome.add({0.1 + 0.0006 * k, 0.1 + 0.0008 * k}, 0);
  CHECK(judge.missed().find("the table ended 20.00 mm from the last of 501 points, above 2.5") ==
        0);
  judge.lagging = {0.118, 0.124};  // 20 mm
  CHECK(judge.missed() == "");
  CHECK(judge.outcome.limit_at_end_m(0.001) == judge.outcome.limit_m());
  CHECK(judge.outcome.limit_at_end_m(0.016) == Approx(0.02));
  CHECK(judge.outcome.limit_at_end_m(0.05) == Approx(0.025));
  Options options = line();
  options.reached_m = 0.015;
  CHECK(Judge(options).outcome.limit_at_end_m(0.016) == 0.015);
}

TEST_CASE("a table lags as the model of its slower axis does, whichever that is") {
  for (const std::size_t slow : {0u, 1u}) {
    for (const double omega : {10.0, 20.0}) {
      Options options;
      options.gains[slow].omega_n_rad_s = omega;
      options.gains[slow].zeta = 0.8;
      CAPTURE(slow, omega);
      CHECK(options.lag_s() == Approx(1.6 / omega));
    }
  }
}

namespace {

// A small circle, half a second long.
Options small_circle() {
  Options options;
  options.run.engine = Engine::kTwin;
  options.run.platform = Platform::kDirect;
  options.path.circle_radius_m = 0.01;
  options.path.circle_ticks = 450;
  return options;
}

}  // namespace

TEST_CASE("a whole run says how far the table is from the last point") {
  const Result result = simulate(small_circle(), {});
  CHECK(result.end == EndReason::kDone);
  CHECK(result.points == 451);
  // The model lags by 2 / omega_n = 67 ms, here 4.6 mm of the circle's arc.
  CHECK(result.from_last_m == Approx(0.0046).margin(0.0005));
  CHECK_THAT(verdict(small_circle(), result), Catch::Contains(" mm from the last one"));
}

TEST_CASE("a processor that dies before the last points leaves an end of its own") {
  Options options = small_circle();
  options.fault = {cosim::FaultKind::kProcessorHung, 0.87};
  const Result result = simulate(options, {});
  CHECK(result.end == EndReason::kMissed);
  CHECK(result.points < 451);
  const std::string what = "stopped after " + std::to_string(result.points) + " of 451 points";
  CHECK(verdict(options, result) == "missed: " + what);
  CHECK(result.fault_text() == what);
}

TEST_CASE("a table that stands still beside a small circle has not followed it") {
  Options options = small_circle();
  SECTION("no current is asked for") {
    for (AxisGains& gains : options.gains) gains.kv = 0;
  }
  SECTION("friction holds it") {
    for (plant::AxisConfig& axis : options.plant.axis) axis.coulomb_n = 500;
  }
  SECTION("a lap takes less than the 250 ms in which a point of the path is near") {
    options.path.circle_ticks = 60;
    for (AxisGains& gains : options.gains) gains.kv = 0;
  }
  const Result result = simulate(options, {});
  CHECK(result.end == EndReason::kMissed);
  CHECK_THAT(verdict(options, result), Catch::StartsWith("missed: the table "));
}

TEST_CASE("distance from the path asked is that from the line through its last points") {
  CommandedPath path = commanded_line();
  // Point n comes at sample 4 n, 1 mm further; the table lags by 40 samples and is 3 mm beside.
  for (int k = 0; k < 400; ++k) {
    const double x_m = 0.1 + 0.001 * std::max(0, k / 4 - 10);
    CHECK(path.distance_m({x_m, 0.103}, 0) == Approx(0.003));
  }
}

TEST_CASE("a table that stands still is left behind by the path asked") {
  CommandedPath path = commanded_line();
  double last = 0;
  for (int k = 0; k < 2000; ++k) {
    const double distance = path.distance_m({0.1, 0.1}, 0);
    CHECK(distance >= last);
    last = distance;
  }
  CHECK(last == Approx(0.1).margin(0.0011));  // the end, once the way there is 250 ms old
}

TEST_CASE("what was asked some samples ago is known, as far as is searched") {
  CommandedPath path = commanded_line();
  for (int k = 0; k < 200; ++k) path.distance_m({0.1, 0.1}, 0);  // point n comes at sample 4 n
  CHECK(path.commanded().x_m == Approx(0.149));
  CHECK(path.commanded(3).x_m == Approx(0.149));
  CHECK(path.commanded(4).x_m == Approx(0.148));
  CHECK(path.commanded(133).x_m == Approx(0.116));
  CHECK(path.commanded(5000).x_m == Approx(0.1));
}

TEST_CASE("a search for the nearest point ends where enough is known") {
  CommandedPath path = commanded_line();
  for (int k = 0; k < 100; ++k) path.distance_m({0.1, 0.1}, 0);
  const double some = path.distance_m({0.1, 0.102}, 0.05);
  CHECK(some < 0.05);
  CHECK(some >= 0.002);
}
