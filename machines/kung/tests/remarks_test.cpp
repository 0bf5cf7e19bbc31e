// SPDX-License-Identifier: Apache-2.0
//
// What is said below the figures of a run, why it ended, and which profile it has.
#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <string>

#include "machines/kung/machine.hpp"
#include "machines/kung/plan_feed.hpp"

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
