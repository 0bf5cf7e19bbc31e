// SPDX-License-Identifier: Apache-2.0
//
// What is said below the figures of a run, why it ended, and what the paper prints beside ours.
#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/scenarios.hpp"
#include "machines/kung/chip/measures.hpp"
#include "machines/kung/judge/figures.hpp"
#include "machines/kung/judge/motor_load.hpp"
#include "machines/kung/judge/paper.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/precision/figures.hpp"
#include "machines/kung/run/cpu.hpp"

using namespace trammel;
using namespace trammel::kung;

namespace {

struct Ours {
  std::string id;
  double value;
  std::optional<double> printed{};
};

lab::Record record_of(PathKind path, Controller controller, const std::vector<Ours>& list,
                      EndReason end = EndReason::kDone, const char* scenario = "circle") {
  lab::Record record;
  auto options = std::make_shared<Options>();
  options->scenario = scenario;
  options->path.kind = path;
  options->controller = controller;
  record.settings = std::move(options);
  record.result = std::make_unique<Result>();
  record.result->end = end;
  for (const Ours& one : list) {
    record.figures.push_back(lab::figure(one.id, "", "", one.value, ""));
    record.figures.back().printed = one.printed;
  }
  return record;
}

std::vector<Ours> tracking(double mean, double printed_mean, double variance,
                           double printed_variance, double std) {
  return {{"tracking.model.mean_mm", mean, printed_mean},
          {"tracking.model.variance_mm2", variance, printed_variance},
          {"tracking.model.std_mm", std}};
}

// Words with single blanks between, each line between bars.
std::string plain(const std::string& text) {
  std::string out = "|";
  for (const char c : text) {
    if (c == '\n') {
      while (out.back() == ' ') out.pop_back();
      out += '|';
    } else if (c != ' ' || (out.back() != ' ' && out.back() != '|')) {
      out += c;
    }
  }
  return out;
}

}  // namespace

TEST_CASE("why clocks were evaluated is told in order, from half a tenth of a percent on") {
  const auto said = [](const WakeCounts& wakes) -> std::string {
    auto result = std::make_unique<Result>();
    result->evaluated = 10'000;
    result->wakes = wakes;
    lab::Record record;
    record.settings = std::make_shared<Options>();
    record.result = std::move(result);
    for (const std::string& line : remarks(record)) {
      if (line.rfind("clocks evaluated for: ", 0) == 0) return line.substr(22);
    }
    return "nothing";
  };
  CHECK(said({5000, 4, 5, 1000, 2000, 1500, 400, 91}) ==
        "leap 50.0 %, tick 0.1 %, converter 10.0 %, current loop 20.0 %, position controller "
        "15.0 %, encoder 4.0 %, gate 0.9 %");
  CHECK(said({4, 4, 4, 4, 4, 4, 4, 4}) == "nothing");
  for (std::size_t n = 0; n < kWakes; ++n) {
    WakeCounts wakes{};
    wakes[n] = 10'000;
    std::string name = kWakeNames[n];
    for (char& c : name) c = c == '_' ? ' ' : c;
    CHECK(said(wakes) == name + " 100.0 %");
  }
}

TEST_CASE("below the figures stand overloads, ranges, and the times of the processor") {
  auto options = std::make_shared<Options>();
  options->controller = Controller::kPrecision;
  auto result = std::make_unique<Result>();
  result->load[1].peak_current_A = 5;
  result->load[0].at_current = 40;
  for (const cosim::Clk clocks : {3000, 3500}) result->core.emplace().routine.add(clocks);
  const std::vector<std::string> all[] = {overloads(*options, *result),
                                          range_lines(*options, *result),
                                          cpu_lines(*options, *result)};
  std::vector<std::string> expected;
  for (const auto& lines : all) {
    CHECK_FALSE(lines.empty());
    expected.insert(expected.end(), lines.begin(), lines.end());
  }
  lab::Record record;
  record.settings = options;
  record.result = std::move(result);
  CHECK(remarks(record) == expected);
}

TEST_CASE("metrics of a run hold its processor's clocks, and of a precision run feed and paper") {
  const auto metrics = [](Controller controller, bool core) {
    auto options = std::make_shared<Options>();
    options->controller = controller;
    auto result = std::make_unique<Result>();
    result->points = 7;
    result->first_tick = 11;
    result->end_tick = 39;
    if (core) {
      cosim::CoreTimes& times = result->core.emplace();
      for (const cosim::Clk clocks : {3000, 3500}) times.routine.add(clocks);
      times.first.add(106);
      times.transfers.add(14);
      times.answer.add(2);
      times.between.add(9);
      result->core_awake = 12345;
    }
    lab::Record record;
    record.settings = options;
    record.result = std::move(result);
    nlohmann::ordered_json json;
    machine().files.metrics(record, json);
    return json;
  };
  const auto fuzzy = metrics(Controller::kAfc, false);
  CHECK(fuzzy["run"]["points"] == 7);
  CHECK(fuzzy["run"]["first_tick"] == 11);
  CHECK(fuzzy["run"]["end_tick"] == 39);
  CHECK_FALSE(fuzzy["run"].contains("feed_m_s"));
  CHECK_FALSE(fuzzy.contains("paper"));
  CHECK_FALSE(fuzzy.contains("processor"));
  const auto precise = metrics(Controller::kPrecision, true);
  CHECK(precise["run"]["feed_m_s"] == 0.5);
  CHECK(precise["paper"]["AFC"]["mean_mm"] == 2.05);
  CHECK(precise["paper"]["FC"]["mean_mm"] == 3.51);
  const auto& core = precise["processor"];
  CHECK(core["routine_clk"]["count"] == 2);
  CHECK(core["routine_clk"]["worst"] == 3500);
  CHECK(core["routine_clk"]["mean"] == 3250);
  CHECK(core["first_access_clk"]["mean"] == 106);
  CHECK(core["transfers"]["mean"] == 14);
  CHECK(core["answer_clk"]["mean"] == 2);
  CHECK(core["between_clk"]["mean"] == 9);
  CHECK(core["interrupt_period_clk"] == Approx(100'000));  // 2 ms of 50 MHz
  CHECK(core["awake_clk"] == 12345);
}

TEST_CASE("what is told of the end of a run is of that end") {
  Result result;
  result.fault = {FaultCode::kOverCurrent, 1, 17};
  result.missed = "the table missed it";
  result.uart = "what the port sent";
  for (const EndReason end : {EndReason::kDone, EndReason::kDiverged, EndReason::kTimeout,
                              EndReason::kStopped, EndReason::kAssertion}) {
    result.end = end;
    INFO("fault_text of end " << static_cast<int>(end));
    CHECK(result.fault_text().empty());
  }
  result.end = EndReason::kFault;
  CHECK(result.fault_text() == "over-current on axis Y");
  result.end = EndReason::kMissed;
  CHECK(result.fault_text() == "the table missed it");
}

TEST_CASE("a path has the feed profile where it is asked, of lines, or of the precision one") {
  for (const PathKind kind : {PathKind::kCircle, PathKind::kWindow, PathKind::kStar,
                              PathKind::kSquare, PathKind::kLine, PathKind::kPoints,
                              PathKind::kSweep, PathKind::kFeed}) {
    for (const PointsMode mode : {PointsMode::kTimed, PointsMode::kPath}) {
      for (const Controller controller :
           {Controller::kFc, Controller::kAfc, Controller::kPrecision}) {
        Options options;
        options.path.kind = kind;
        options.path.points_mode = mode;
        options.controller = controller;
        const bool timed = kind == PathKind::kPoints && mode == PointsMode::kTimed;
        const bool lines = kind == PathKind::kFeed || (kind == PathKind::kPoints && !timed);
        const bool can = kind != PathKind::kSweep && !timed;
        CAPTURE(static_cast<int>(kind), static_cast<int>(mode), static_cast<int>(controller));
        options.path.profile = Profile::kAuto;
        CHECK(feeds(options) == (can && (lines || controller == Controller::kPrecision)));
        options.path.profile = Profile::kFeed;
        CHECK(feeds(options) == can);
        options.path.profile = Profile::kConstant;
        CHECK_FALSE(feeds(options));
      }
    }
  }
}

// docs/figures.md has what is printed and expected in each scenario.
TEST_CASE("by another controller or with an own gain nothing is printed or expected") {
  for (const char* const scenario : {"circle", "window", "star", "step", "paper-circle"}) {
    for (const bool own : {false, true}) {
      const auto settings = lab::load_scenario(lab::find_scenario(scenario));
      auto options = static_cast<const Options&>(*settings);
      if (own) {
        options.gains[1].kp *= 2;
      } else {
        options.controller = Controller::kPrecision;
      }
      for (const char* const id : {"tracking.model.mean_mm", "tracking.model.variance_mm2",
                                   "tracking.model.std_mm", "x.periods.0.overshoot_percent",
                                   "x.periods.0.rms_mm", "peak_current_A"}) {
        std::vector<lab::Figure> figures{lab::figure(id, "", "", 0, "")};
        compare(options, figures);
        CAPTURE(scenario, own, id);
        CHECK_FALSE(figures[0].printed);
        CHECK_FALSE(figures[0].expected);
        CHECK(figures[0].source.empty());
      }
    }
  }
}

TEST_CASE("the table of the experiments holds each value in the cell of its path and controller") {
  std::vector<lab::Record> all;
  const auto add = [&](auto&&... of) { all.push_back(record_of(of...)); };
  using K = PathKind;
  using C = Controller;
  add(K::kCircle, C::kFc, tracking(4, 3, 0.5, 0.6, 0.71));
  add(K::kWindow, C::kFc, tracking(2, 1, 0.8, 0.9, 0.72));
  add(K::kStar, C::kFc, tracking(5, 8, 1.1, 1.2, 0.73));
  add(K::kCircle, C::kAfc, tracking(3, 2.1, 0.4, 0.3, 0.74));
  add(K::kWindow, C::kAfc, tracking(1.5, 0.9, 1.6, 1.8, 0.75));
  add(K::kStar, C::kAfc, tracking(4.5, 7, 1, 1, 0.76), EndReason::kFault);
  add(K::kSquare, C::kFc,
      std::vector<Ours>{{"x.periods.0.overshoot_percent", 12.1, 12.8},
                        {"y.periods.0.overshoot_percent", 23.2, 23.1},
                        {"x.periods.7.overshoot_percent", 11.3},
                        {"y.periods.7.overshoot_percent", 22.4}});
  add(K::kSquare, C::kAfc,
      std::vector<Ours>{{"x.periods.0.overshoot_percent", 5.0},
                        {"y.periods.0.overshoot_percent", 23.5},
                        {"x.periods.1.overshoot_percent", 4.9},
                        {"y.periods.1.overshoot_percent", 5.1},
                        {"x.periods.7.overshoot_percent", 1.2},
                        {"y.periods.7.overshoot_percent", 6.6}});
  const auto errors = [](double mean, double most) {
    return std::vector<Ours>{{"error_um.mean", mean}, {"error_um.max", most}};
  };
  add(K::kCircle, C::kPrecision, errors(2.04, 15.31));
  add(K::kWindow, C::kPrecision, errors(99.99, 101.26));
  all[8].companions.push_back(record_of(K::kCircle, C::kFc, errors(100.4, 2000.6)));
  all[8].companions.back().name = "FC";
  all[8].companions.push_back(
      record_of(K::kCircle, C::kAfc, errors(1, 2), EndReason::kDiverged));
  all[8].companions.back().name = "AFC";
  add(K::kCircle, C::kAfc, tracking(6, 2.1, 0.2, 0.3, 0.77), EndReason::kDone, "paper-circle-afc");
  add(K::kStar, C::kAfc, tracking(7.5, 7, 2, 1, 0.78), EndReason::kDone, "paper-star-afc");
  add(K::kSquare, C::kAfc, std::vector<Ours>{{"x.periods.0.overshoot_percent", 4.5}},
      EndReason::kDone, "paper-step-afc");
  std::vector<const lab::Record*> records;
  for (const lab::Record& record : all) records.push_back(&record);
  const std::string text = plain(experiments_text(records));
  for (const char* const line : {
           "|Tracking error in mm (Kung Table 2), defaults / paper-* / printed||circle window ",
           "|Step of 10 mm with 11 kg (Kung Figs. 11, 12), defaults / paper-* / printed||",
           "|FC mean 4.00 / - / 3.00 2.00 / - / 1.00 5.00 / - / 8.00|",
           "|FC variance 0.50 / - / 0.60 0.80 / - / 0.90 1.10 / - / 1.20|",
           "|FC std 0.71 / - / - 0.72 / - / - 0.73 / - / -|",
           "|AFC mean 3.00 / 6.00 / 2.10 1.50 / - / 0.90 - / 7.50 / 7.00|",
           "|AFC variance 0.40 / 0.20 / 0.30 1.60 / - / 1.80 - / 2.00 / 1.00|",
           "|AFC std 0.74 / 0.77 / - 0.75 / - / - - / 0.78 / -|",
           "|reduction of mean 25.0 / - / 30.0 % 25.0 / - / 10.0 % -|",
           "|reduction of variance 20.0 / - / 50.0 % -100.0 / - / -100.0 % -|",
           "|overshoot (%) first period last period|",
           "|FC X 12.1 / - / 12.8 11.3 / - / -|",
           "|FC Y 23.2 / - / 23.1 22.4 / - / -|",
           "|AFC X 5.0 / 4.5 / - 1.2 / - / -|",
           "|AFC Y 23.5 / - / - 6.6 / - / -|",
           "|defaults, X: below 5 % in period 2|",
           "|defaults, Y: never below 5 %|",
           "|paper-*, X: below 5 % in period 1|",
           "|paper-*, Y: never below 5 %|",
           "|FC 100 / 2001 not finished not finished|",
           "|AFC not finished not finished not finished|",
           "|precision 2.04 / 15.3 99.99 / 101.3 not finished|"}) {
    INFO("the line " << line << " of experiments_text in " << text);
    CHECK_THAT(text, Catch::Contains(line));
  }
}
