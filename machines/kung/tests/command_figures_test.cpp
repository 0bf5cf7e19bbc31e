// SPDX-License-Identifier: Apache-2.0
//
// Figures and table of a run under the feed profile, of a record made by hand: a table that is off
// its command by what is known at each sample.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lab/report_data.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/judge/comparison.hpp"
#include "machines/kung/judge/figures.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/precision/figures.hpp"
#include "machines/kung/precision/trace.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "tests/support/scratch.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

constexpr std::uint32_t kFirst = 9;
constexpr double kSampleS = 0.5e-3, kUmInMetre = 1e6;

// Up a line of 30 x 40 mm from (0.1, 0.2) m.
Options line(Controller controller) {
  Options options;
  options.controller = controller;
  options.path.kind = PathKind::kLine;
  options.path.profile = Profile::kFeed;
  options.path.line_start_x_m = 0.1;
  options.path.line_start_y_m = 0.2;
  options.path.line_end_x_m = 0.13;
  options.path.line_end_y_m = 0.24;
  return options;
}

// Command less place at a time: some um, each axis its own; the largest at the path's begin.
std::array<double, 2> error_m(double t_s) {
  return {(t_s < 1e-9 ? 40 : 4 * std::sin(300 * t_s)) / kUmInMetre,
          (t_s < 1e-9 ? -70 : -6 - 5 * std::cos(200 * t_s)) / kUmInMetre};
}

// Time of a sample since point 0 was the command. The precision controller's set point is that of
// a point 62 of its ticks of 1 / 16000 s after the knot that takes it.
double time_s(std::uint32_t tick, Controller controller) {
  return kSampleS * (tick - static_cast<double>(kFirst)) -
         (controller == Controller::kPrecision ? 62.0 / 16000 : 0);
}

using ErrorAt = std::function<std::array<double, 2>(double t_s)>;

Result by_hand(const Options& options, const ErrorAt& error_at = error_m) {
  const ideal::FeedProfile command = ideal_command(options, feed_moves(options));
  Result result;
  result.first_tick = kFirst;
  result.points = static_cast<std::uint32_t>(command.points());
  result.end_tick = kFirst + 4 * result.points;
  for (std::uint32_t tick = 1; tick < result.end_tick + 30; ++tick) {
    Sample sample;
    sample.tick = tick;
    sample.edge = 25'000 * static_cast<cosim::Clk>(tick) + 77;
    const double t_s = time_s(tick, options.controller);
    const bool counts = t_s > -1e-9 && t_s < command.seconds() + 1e-9;
    const ideal::Place at = command.at(std::max(0.0, t_s)).p;
    const std::array<double, 2> asked{at.x, at.y}, error = error_at(t_s);
    for (std::size_t a = 0; a < 2; ++a) {
      sample.axis[a].x_true_m = counts ? asked[a] - error[a] : 0.5;
      sample.axis[a].set_point = static_cast<std::int32_t>(
          std::lround((asked[a] + (a == 0 ? 3e-6 : -4e-6)) / 5e-6 * 256));
    }
    result.samples.push_back(sample);
    if (options.controller == Controller::kPrecision) result.laws.push_back({});
  }
  return result;
}

std::map<std::string, double> figures_of(const Options& options, const Result& result) {
  std::vector<lab::Figure> list;
  add_command_figures(list, *make_plan(options), result);
  std::map<std::string, double> all;
  for (const lab::Figure& f : list) all[f.id] = f.value;
  return all;
}

void check_errors(const std::map<std::string, double>& figures, const std::string& id,
                  std::vector<double> um) {
  double sum = 0, squares = 0;
  for (const double one : um) {
    sum += one;
    squares += one * one;
  }
  std::sort(um.begin(), um.end());
  std::size_t rank = 0;  // the first that 99 % do not exceed
  while (100 * (rank + 1) < 99 * um.size()) ++rank;
  INFO(id);
  const auto n = static_cast<double>(um.size());
  CHECK(figures.at(id + ".mean") == Approx(sum / n));
  CHECK(figures.at(id + ".rms") == Approx(std::sqrt(squares / n)));
  CHECK(figures.at(id + ".p99") == Approx(um[rank]));
  CHECK(figures.at(id + ".max") == Approx(um.back()));
}

}  // namespace

TEST_CASE("errors to the command are those of the samples from point 0 to the last one") {
  for (const Controller controller : {Controller::kAfc, Controller::kPrecision}) {
    const Options options = line(controller);
    const Result result = by_hand(options);
    std::vector<double> both, x, y, contour;
    const double end_s = ideal_command(options, feed_moves(options)).seconds();
    for (std::uint32_t tick = 1; tick <= result.samples.size(); ++tick) {
      const double t_s = time_s(tick, controller);
      if (t_s < -1e-9 || t_s > end_s + 1e-9) continue;
      const auto [ex, ey] = error_m(t_s);
      both.push_back(kUmInMetre * std::hypot(ex, ey));
      x.push_back(kUmInMetre * std::abs(ex));
      y.push_back(kUmInMetre * std::abs(ey));
      // Of the line (0.6, 0.8): along it between its ends, or to the one that is nearer.
      const Sample s = result.samples[tick - 1];
      const double dx = s.axis[0].x_true_m - 0.1, dy = s.axis[1].x_true_m - 0.2;
      const double along = 0.6 * dx + 0.8 * dy, end = std::clamp(along, 0.0, 0.05);
      contour.push_back(kUmInMetre * std::hypot(dx - 0.6 * end, dy - 0.8 * end));
    }
    CAPTURE(static_cast<int>(controller), both.size());
    REQUIRE(both.size() > 300);
    const auto figures = figures_of(options, result);
    check_errors(figures, "error_um", both);
    check_errors(figures, "x.error_um", x);
    check_errors(figures, "y.error_um", y);
    check_errors(figures, "contour_um", contour);
    CHECK(figures.count("set_point_um.mean") == (controller == Controller::kPrecision ? 1 : 0));
    if (controller != Controller::kPrecision) {
      CHECK(figures.at("error_um.max") == Approx(std::hypot(40, 70)));  // of point 0
      continue;
    }
    // 3 and -4 um, within half a step of 5 um / 256 of each axis.
    CHECK(figures.at("set_point_um.mean") == Approx(5).margin(0.015));
    CHECK(figures.at("set_point_um.max") == Approx(5).margin(0.015));
  }
}

TEST_CASE("a record has one contour error and one error to the command, by one name each") {
  for (const bool fed : {true, false}) {
    Options options = line(Controller::kAfc);
    if (!fed) options.path.profile = Profile::kConstant;
    options.path.repeats = 2;
    Result result = by_hand(options);
    for (const std::string of : {"contour", "command", "error_um"}) {
      std::string ids;
      for (const lab::Figure& f : figures(options, result)) {
        const bool mean = f.id.find("mean") != std::string::npos;
        const bool axis = f.id[0] == 'x' || f.id[0] == 'y';
        if (mean && !axis && f.id.find(of) != std::string::npos) ids += f.id + " ";
      }
      CAPTURE(fed);
      if (of == "contour") {
        CHECK(ids == (fed ? "contour_um.mean "
                          : "contour.mean_mm laps.0.contour.mean_mm laps.1.contour.mean_mm "));
      }
      if (of == "command") CHECK(ids == (fed ? "" : "tracking.command.mean_mm "));
      if (of == "error_um") CHECK(ids == (fed ? "error_um.mean " : ""));
    }
  }
}

TEST_CASE("nothing is told of a run that ended before its path's first sample") {
  const Options options = line(Controller::kPrecision);
  Result result = by_hand(options);
  result.first_tick = static_cast<std::uint32_t>(result.samples.size() + 1);
  result.end_tick = result.first_tick + 100;
  CHECK(figures_of(options, result).empty());
  result.first_tick = kFirst;
  result.points = 0;
  CHECK(figures_of(options, result).empty());
}

TEST_CASE("each lap has its mean error, the first eight and the last are shown") {
  Options options = line(Controller::kPrecision);
  options.path.repeats = 11;
  const double lap_s = ideal_command(options, feed_moves(options)).seconds() / 11;
  Result result = by_hand(options, [lap_s](double t_s) -> std::array<double, 2> {
    const double lap = std::floor(std::clamp(t_s / lap_s, 0.0, 10.9));
    return {1.8e-6 * (lap + 1), -2.4e-6 * (lap + 1)};  // of 3 um more in each
  });
  std::vector<lab::Figure> list;
  add_command_figures(list, *make_plan(options), result);
  for (std::size_t lap = 0; lap < 11; ++lap) {
    const lab::Figure* const f = lab::find_figure(list, "lap_error_um." + std::to_string(lap));
    CAPTURE(lap);
    REQUIRE(f != nullptr);
    CHECK(f->value == Approx(3.0 * static_cast<double>(lap + 1)).epsilon(0.01));
    CHECK(f->row == "lap " + std::to_string(lap + 1));
    CHECK(f->shown == (lap < 8 || lap == 10));
  }
  CHECK(lab::find_figure(list, "lap_error_um.11") == nullptr);
  result.end = EndReason::kMissed;
  CHECK(figures_of(options, result).count("lap_error_um.0") == 0);
}

TEST_CASE("precision.csv has the error against the feed profile, and which samples count") {
  const Options options = line(Controller::kPrecision);
  const Result result = by_hand(options);
  const test::Scratch scratch("command_figures");
  write_precision(scratch.path / kPrecisionTrace, *make_plan(options), result);
  lab::RunFolder run;
  run.folder = scratch.path;
  run.rows = result.samples.size();
  lab::read_table(kPrecisionTrace, precision_columns(), run);
  const ideal::FeedProfile command = ideal_command(options, feed_moves(options));
  for (std::uint32_t tick = 1; tick <= run.rows; ++tick) {
    const auto at = [&](const std::string& column) { return run.columns.at(column)[tick - 1]; };
    const double t_s = time_s(tick, options.controller);
    const bool counts = t_s > -1e-9 && t_s < command.seconds() + 1e-9;
    CAPTURE(tick, t_s);
    REQUIRE(at("counted") == (counts ? 1 : 0));
    if (!counts) continue;
    const ideal::FeedProfile::Command asked = command.at(t_s);
    CHECK(at("x_error_um") == Approx(kUmInMetre * error_m(t_s)[0]).margin(1e-3));
    CHECK(at("y_error_um") == Approx(kUmInMetre * error_m(t_s)[1]).margin(1e-3));
    CHECK(at("x_command_m_s") == Approx(asked.v.x).margin(1e-6));
    CHECK(at("y_command_m_s") == Approx(asked.v.y).margin(1e-6));
    CHECK(at("x_command_m_s2") == Approx(asked.a.x).margin(1e-3));
    CHECK(at("y_command_m_s2") == Approx(asked.a.y).margin(1e-3));
  }
}

TEST_CASE("a precision run is compared with AFC and FC on its path and table, by plain twins") {
  Options options = line(Controller::kPrecision);
  options.path.profile = Profile::kAuto;
  options.path.kind = PathKind::kCircle;
  options.path.circle_radius_m = 0.01;
  options.path.repeats = 2;
  options.plant.axis[1].payload_kg = 3;
  options.run.wave = cosim::WaveFormat::kFst;
  options.run.assertions = options.run.audit = true;
  options.cpu = Cpu::kRtl;
  options.uart = "pty";
  options.precision.learn = true;
  options.diverged_m = 0.01;
  const auto companions = precision_companions(options);
  REQUIRE(companions.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& other = static_cast<const Options&>(*companions[k].settings);
    CAPTURE(companions[k].name);
    CHECK(companions[k].name == (k == 0 ? "AFC" : "FC"));
    CHECK(other.controller == (k == 0 ? Controller::kAfc : Controller::kFc));
    CHECK_FALSE(companions[k].printed);
    CHECK(feeds(other));
    CHECK(other.path.line_end_y_m == 0.24);
    CHECK(other.plant.axis[1].payload_kg == 3);
    CHECK(other.run.engine == Engine::kTwin);
    CHECK(other.run.platform == Platform::kDirect);
    CHECK(other.run.wave == cosim::WaveFormat::kNone);
    CHECK_FALSE((other.run.assertions || other.run.audit || other.precision.learn));
    CHECK(other.cpu == Cpu::kNative);
    CHECK(other.uart.empty());
    CHECK(other.diverged_m == 1);  // however far behind, it is told how far
    CHECK(other.reached_m == 1);
  }
  options.precision.compare = false;
  CHECK(precision_companions(options).empty());
  options.precision.compare = true;
  options.controller = Controller::kAfc;
  CHECK(precision_companions(options).empty());
}
