// SPDX-License-Identifier: Apache-2.0
//
// What is told of a run of the machine larson: remarks and metrics up to their last, verdicts; and
// what its session says of itself. docs/figures.md lists the figures.
#include <catch2/catch.hpp>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cosim/trigger_search.hpp"
#include "lab/record.hpp"
#include "machines/larson/machine.hpp"
#include "machines/larson/session.hpp"
#include "machines/larson/tests/scripted.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/message.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::larson;
using Lines = std::vector<std::string>;

namespace {

lab::Record record_of(Result result) {
  return lab::judged(Options{}.clone(), std::make_unique<Result>(std::move(result)));
}

Result with_calls(int calls) {
  Result result;
  for (int n = 0; n < calls; ++n) {
    Call one;
    one.call.op = sw::LarsonOp::kWttbl;
    one.text = "WTTBL";
    one.line = static_cast<std::size_t>(n + 1);
    result.calls.push_back(one);
    result.answers.push_back({1, {}});
    result.done.push_back({50'000 * (n + 1), {1, 2}, {}, {}});
  }
  return result;
}

}  // namespace

TEST_CASE("larson: twelve answers are remarks, all up to 2000 are metrics") {
  for (const int calls : {12, 13}) {
    const Lines lines = remarks(record_of(with_calls(calls)));
    CAPTURE(calls);
    REQUIRE(lines.size() == static_cast<std::size_t>(calls));
    CHECK(lines[11] == "    0.0120 s  WTTBL: normal");
    if (calls == 13) CHECK(lines[12] == "... all answers are in metrics.json and on the page");
  }
  for (const int calls : {1999, 2000, 2001}) {
    nlohmann::ordered_json json;
    machine().metrics(record_of(with_calls(calls)), json);
    CHECK(json["calls"].size() == static_cast<std::size_t>(std::min(calls, 2000)));
  }
}

TEST_CASE("larson: a run that was stopped or broke a promise says so") {
  Result result;
  result.promise = {"one_master", "larson_xy.u_bus", "bus/props.sv:7", 50'000};
  result.end = cosim::EndReason::kPromise;
  CHECK(machine().verdict(Options{}, result) ==
        "assertion failed: one_master of larson_xy.u_bus at 0.00100000 s, clock 50000 "
        "(bus/props.sv:7)");
  result.end = cosim::EndReason::kStopped;
  CHECK(machine().verdict(Options{}, result) == "interrupted");
}

TEST_CASE("larson: a session tells its clock, its processor, its end and the place of each axis") {
  ScriptedTwin script("CALTBL\n");
  test::set_timing(script.options);
  Session session(script.options, {});
  test::check_timing(session, 20'000);
  const auto places = session.places();
  REQUIRE(places.size() == 2);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    CAPTURE(k);
    CHECK(places[k].axis == (k == 0 ? "x" : "y"));
    CHECK(places[k].unit == "step");
    CHECK(places[k].value == Approx(k == 0 ? 12 : 31));
  }
}

TEST_CASE("larson: a run can be stopped, or ends at its time") {
  ScriptedTwin script("CALTBL\nABSTBL 60 33\nWTTBL\n");
  std::atomic<bool> stop{false};
  cosim::Hooks hooks;
  hooks.stop = &stop;
  hooks.progress = [&stop](double) { stop = true; };  // told after 64 samples
  const Result stopped = lab::simulate(script.options, hooks);
  CHECK(stopped.end == cosim::EndReason::kStopped);
  CHECK(stopped.samples.size() == 64);
  Options late = script.options;
  late.run.max_s = 0.05;
  CHECK(lab::simulate(late).end == cosim::EndReason::kTimeout);
}

TEST_CASE("larson: a run that is cut names the line of its script that was running") {
  const auto cut = [](const std::string& script, double max_s) {
    ScriptedTwin run(script);
    run.options.run.max_s = max_s;
    return lab::run(run.options);
  };
  const std::string script = "# to and fro\nCALTBL\nREPEAT 2\nABSTBL 60 33\n  wait 40000\nEND\n";
  CHECK(cut(script, 0.01).verdict ==
        "not finished within run.max_s = 0.01: script.table:2: CALTBL was running");
  const lab::Record waits = cut(script, 2);
  CHECK(waits.verdict ==
        "not finished within run.max_s = 2: script.table:5: WAIT 40000 was running");
  CHECK(lab::cause_text(*waits.result) == ": script.table:5: WAIT 40000 was running");
  CHECK(lab::exit_code(waits.result->end) == 5);
  CHECK(cut("MOV XCOUNT 0\nMOV XSTATUS 030000\n", 0.02).verdict ==
        "not finished within run.max_s = 0.02: script.table:2: MOV XSTATUS 030000 had ended, the "
        "moves or record.settle_s had not");
}

TEST_CASE("larson: times that Larson prints stand beside his motor, buffer and processor alone") {
  const auto told = [](double torque_share) {
    ScriptedTwin run("CALTBL\nVELTBL 4000 400\nREPEAT 2\nRELTBL 1 0\nWTTBL\nWAIT 300\nEND\n");
    run.options.axis.motor.torque_share = torque_share;
    std::map<std::string, bool> printed;
    for (const lab::Figure& one : lab::run(run.options).figures) {
      if (one.unit == "ms") printed[one.id] = one.printed || one.expected || !one.source.empty();
    }
    return printed;
  };
  const auto his = told(1), weak = told(0.5);
  REQUIRE(his.size() == 3);  // one step, and the periods of both places
  REQUIRE(weak.size() == 3);
  for (const auto& [id, beside] : his) {
    CAPTURE(id);
    CHECK(beside);
    CHECK_FALSE(weak.at(id));
  }
}

TEST_CASE("larson: a run ends where a trigger of either axis is found") {
  for (const std::string axis : {"x", "y"}) {
    const ScriptedTwin script("CALTBL\nABSTBL 60 33\nWTTBL\n");
    cosim::TriggerSearch search(cosim::parse_trigger(axis + ".waiting > 0", triggers()));
    const Result result = test::run_to<Session, Result>(script.options, &search);
    CAPTURE(axis);
    REQUIRE(search.found());
    CHECK(result.end == cosim::EndReason::kDone);
    CHECK(result.fault == "");  // it is not asked where the table is
    const Sample last = result.samples.back();
    CHECK(last.edge == *search.found());
    CHECK(last.axis[axis == "x" ? 0 : 1].waiting > 0);
  }
}

TEST_CASE("larson: a start behind a stop of either axis is refused, on the stop it is not") {
  const auto told = [](const std::string& keys) {
    return test::message_of<Options>("[axis]\n" + keys);
  };
  const std::string low = "switch_low_step = -5\nswitch_hysteresis_step = 1\novertravel_step = 2\n";
  CHECK(told(low + "start_x_step = -8\nstart_y_step = -8\n") == "");
  CHECK_THAT(told(low + "start_x_step = -9\n"),
             Catch::EndsWith("axis.start_x_step: -9 is behind the stop at -8, axis.overtravel_step "
                             "and axis.switch_hysteresis_step beyond its switch; permitted: -8 to "
                             "6000.5"));
  CHECK(told("switch_high_step = 338\n") == "");
  CHECK_THAT(told("switch_high_step = 337.5\nstart_y_step = 400\n"),
             Catch::StartsWith("axis.start_x_step: 400 is behind the stop at 399.5, "));
  CHECK_THAT(told("switch_high_step = 337.5\nstart_x_step = 0\nstart_y_step = 400\n"),
             Catch::StartsWith("axis.start_y_step: 400 is behind the stop at 399.5, "));
}
