// SPDX-License-Identifier: Apache-2.0
//
// What is told of a run of the machine larson: remarks and metrics up to their last, verdicts,
// events and places; what its session says of itself, and what a trigger reads of it.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cosim/trigger_search.hpp"
#include "lab/record.hpp"
#include "machines/larson/machine_members.hpp"
#include "machines/larson/session.hpp"
#include "machines/larson/tests/scripted.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/scratch.hpp"
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

using Words = std::function<std::int64_t(const Sample&)>;

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
    machine().files.metrics(record_of(with_calls(calls)), json);
    CHECK(json["calls"].size() == static_cast<std::size_t>(std::min(calls, 2000)));
  }
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

TEST_CASE("larson: events are the same, however often a sample is taken") {
  // Into the far switch, and steps lost at it, by a rotor that rings on it.
  const auto happened = [](double record_ms) {
    ScriptedTwin script("CALTBL\nVELTBL 4000 900\nABSTBL 200 30\nWTTBL\nCALTBL\nWHRTBL\n");
    script.options.axis.buffer.fitted = false;
    script.options.axis.switch_high = 25.5;
    script.options.record_ms = record_ms;
    std::vector<std::string> lines;
    for (const Event& one : script.run().happened) {
      lines.push_back(fmt::format("{} {} {} {:.9f} {:o} {:o}", one.edge, one.axis, one.what, one.at,
                                  one.count, one.status));
    }
    return lines;
  };
  const std::vector<std::string> often = happened(0.1);
  CHECK(often.size() > 10);
  CHECK(happened(0.37) == often);
  CHECK(happened(50) == often);
}

TEST_CASE("larson: after lost steps and a new CALTBL places are those of the rotors") {
  for (std::size_t k = 0; k < 2; ++k) {
    ScriptedTwin script(std::string("CALTBL\nVELTBL ") + (k == 0 ? "4000 400" : "400 4000") +
                    "\nABSTBL 400 400\nWTTBL\nVELTBL 400 400\nCALTBL\nABSTBL 30 20\nWTTBL\n"
                    "WHRTBL\n");
    script.options.axis.buffer.fitted = false;
    const Result result = script.run();
    CAPTURE(k);
    REQUIRE(result.lost[k] != 0);
    REQUIRE(result.calibrated);
    CHECK(result.done.back().at[0] == Approx(30).margin(0.1));
    CHECK(result.done.back().at[1] == Approx(20).margin(0.1));
    CHECK(result.end == cosim::EndReason::kMissed);  // of the moves before it
  }
}

TEST_CASE("larson: periods of oscillation are those that the rotors had, 11.5 and 8.6 ms") {
  ScriptedTwin script("CALTBL\nVELTBL 400 400\nREPEAT 2\nRELTBL 1 0\nWTTBL\nWAIT 300\nEND\n");
  const auto period = [&script](const char* id) {
    const lab::Record record = lab::run(script.options);
    for (const lab::Figure& one : record.figures) {
      if (one.id == id) return one.value;
    }
    return 0.0;
  };
  CHECK(period("oscillation.two_ms") == Approx(11.5).epsilon(0.05));
  CHECK(period("oscillation.three_ms") == Approx(8.6).epsilon(0.05));
  // By a torque that they did not have, whatever the keys of the motor are.
  const double whole = period("oscillation.two_ms");
  script.options.axis.motor.torque_share = 0.5;
  CHECK(period("oscillation.two_ms") == Approx(whole * std::sqrt(2)).epsilon(0.02));
}

TEST_CASE("larson: figures, answers and verdict do not depend on the raster of the record") {
  const auto told = [](double every_ms, double max_s) {
    ScriptedTwin script("CALTBL\nVELTBL 2000 400\nABSTBL 60 33\nWHRTBL\nWTTBL\nABSTBL 58 30\n");
    script.options.axis.motor.friction = 0.05;
    script.options.record_ms = every_ms;
    script.options.run.max_s = max_s;
    return test::record_text(lab::run(script.options));
  };
  const std::string fine = told(1, 10);
  CHECK_THAT(fine, Catch::StartsWith("done script.time_s="));
  for (const double every_ms : {0.3, 7.3, 100.0, 1000.0}) {
    CAPTURE(every_ms);
    CHECK(told(every_ms, 10) == fine);
  }
}

TEST_CASE("larson: a run ends where the word of a trigger, of its own axis, first has the value") {
  const test::Scratch scratch("larson_trigger");
  const std::filesystem::path file = scratch.path / "script.table";
  std::ofstream(file) << "CALTBL\nVELTBL 4000 500\nABSTBL 60 33\nWTTBL\nRELTBL -25 -10\nWTTBL\n";
  Options options;
  options.script = file.string();
  options.run.platform = cosim::Platform::kDirect;
  options.run.engine = cosim::Engine::kTwin;
  options.start_x = 12;
  options.start_y = 31;
  options.record_ms = 0.5;
  const Result all = test::run_to<Session, Result>(options, nullptr);
  REQUIRE(all.end == cosim::EndReason::kDone);
  std::vector<std::pair<std::string, Words>> named{
      {"call", [](const Sample& s) { return std::int64_t{s.call}; }},
      {"switches", [](const Sample& s) { return std::int64_t{s.switches}; }}};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string axis = k == 0 ? "x." : "y.";
    named.emplace_back(axis + "count", [k](const Sample& s) { return s.axis[k].words & 0xFFFF; });
    named.emplace_back(axis + "status", [k](const Sample& s) { return s.axis[k].words >> 16; });
    named.emplace_back(axis + "waiting", [k](const Sample& s) { return s.axis[k].waiting; });
  }
  for (const auto& [name, of] : named) {
    // The last value that was not there before.
    std::int64_t value = 0;
    cosim::Clk edge = cosim::kNever;
    std::set<std::int64_t> before;
    for (const Sample& sample : all.samples) {
      if (!before.insert(of(sample)).second) continue;
      value = of(sample);
      edge = sample.edge;
    }
    REQUIRE(before.size() > 1);
    const std::string text = name + " == " + std::to_string(value);
    CAPTURE(text);
    cosim::TriggerSearch search(cosim::parse_trigger(text, triggers(), 20'000));
    const Result found = test::run_to<Session, Result>(options, &search);
    REQUIRE(search.found());
    CHECK(*search.found() == edge);
    CHECK(found.samples.size() < all.samples.size());
    CHECK(found.samples.back().edge == edge);
    CHECK(found.end == cosim::EndReason::kDone);
    CHECK(found.fault == "");  // it is not asked where the table is
  }
}
