// SPDX-License-Identifier: Apache-2.0
//
// What is said below the figures of a run, why it ended, and which profile it has.
#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "machines/kung/machine.hpp"
#include "machines/kung/plan_feed.hpp"
#include "machines/kung/precision_figures.hpp"

using namespace trammel;
using namespace trammel::kung;

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
    choose_profile(*options);
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
    machine().metrics(record, json);
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
                              EndReason::kStopped, EndReason::kPromise}) {
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
        choose_profile(options);
        const bool timed = kind == PathKind::kPoints && mode == PointsMode::kTimed;
        const bool lines = kind == PathKind::kFeed || (kind == PathKind::kPoints && !timed);
        const bool can = kind != PathKind::kSweep && !timed;
        CAPTURE(static_cast<int>(kind), static_cast<int>(mode), static_cast<int>(controller));
        options.path.profile = Profile::kAuto;
        CHECK(feeds(options.path) == (can && (lines || controller == Controller::kPrecision)));
        options.path.profile = Profile::kFeed;
        CHECK(feeds(options.path) == can);
        options.path.profile = Profile::kConstant;
        CHECK_FALSE(feeds(options.path));
      }
    }
  }
}
