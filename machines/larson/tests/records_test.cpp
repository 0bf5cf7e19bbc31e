// SPDX-License-Identifier: Apache-2.0
//
// What the record of a run of the machine larson says of events and places, whatever it is asked.
#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "machines/larson/machine.hpp"
#include "machines/larson/tests/scripted.hpp"

using namespace trammel;
using namespace trammel::larson;

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
    const lab::Record record = lab::run(script.options);
    std::string all = record.verdict;
    for (const lab::Figure& f : record.figures) all += fmt::format(" {}={}", f.id, f.value);
    for (const std::string& line : remarks(record)) all += line;
    nlohmann::ordered_json json;
    add_metrics(record, json);
    return all + json.dump();
  };
  const std::string fine = told(1, 10);
  CHECK_THAT(fine, Catch::StartsWith("done script.time_s="));
  for (const double every_ms : {0.3, 7.3, 100.0, 1000.0}) {
    CAPTURE(every_ms);
    CHECK(told(every_ms, 10) == fine);
  }
}
