// SPDX-License-Identifier: Apache-2.0
//
// What is told of a run of the machine gantry: verdict, remarks, figures beside those of the
// thesis, metrics and its trace, from results made by hand.
#include <catch2/catch.hpp>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lab/layers.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "machines/gantry/machine_members.hpp"
#include "tests/support/figures.hpp"

using namespace trammel;
using namespace trammel::gantry;
using Lines = std::vector<std::string>;
using gantry::Options;
using gantry::Result;
using gantry::Sample;

namespace {

lab::Record record_of(const Options& options, Result result) {
  return lab::judged(options.clone(), std::make_unique<Result>(std::move(result)));
}

nlohmann::ordered_json metrics_of(const Options& options, const Result& result) {
  nlohmann::ordered_json json;
  Result own;
  own.homed = result.homed;
  own.store = result.store;
  add_metrics(record_of(options, std::move(own)), json);
  return json;
}

constexpr cosim::Clk kMs = 50'000;  // [clk]

// A step that is asked for at 0.1 s, to 300 or back, in looks of 1 ms up to 1.1 s: off by 50 %
// until 0.2 s, by 10 % beyond it until 0.3 s, by -1 % until the end, with a swing of 2 mm over the
// last quarter, one of 20 mm in the middle of the time before it and one sample off just before.
Result by_hand(const Options& options) {
  const double step = options.reference_mm - options.from_mm;
  Result result;
  for (int ms = 0; ms <= 1100; ++ms) {
    double off = -0.01 * step;
    if (ms < 100) off = step;  // before it is asked for
    if (ms >= 100 && ms < 200) off = -0.5 * step;
    if (ms >= 200 && ms < 300) off = 0.1 * step;
    if (ms >= 500 && ms < 510) off = -10;
    if (ms >= 510 && ms < 520) off = 10;
    if (ms == 840) off += 0.015 * step;  // in the last quarter of the run, not of the step
    if (ms == 900) off += 1;
    if (ms == 1000) off -= 1;
    Sample s;
    s.edge = ms * kMs;
    s.x = 1e-3 * (options.zero_mm + options.reference_mm + off);
    s.v = ms == 150 ? -0.4 : ms == 700 ? 0.3 : 0;
    s.words.force = {ms == 160 ? -650 : 0, ms == 170 ? -700 : ms == 180 ? 600 : 0};
    result.looks.push_back(s);
  }
  result.passes = 11;
  result.heard = {1, 2, 3};
  result.malformed = 4;
  result.lost = 5;
  result.unknown = 6;
  return result;
}

}  // namespace

TEST_CASE("gantry: where nothing asks for a step it has no overshoot, of no way it is none") {
  Result result;
  CHECK(test::figure(Options{}, result, "step.swing_mm") == 0);  // of a run without a sample
  Options homes;
  homes.firmware.home = true;
  homes.sends = "";
  for (const lab::Figure& f : figures(homes, result)) {
    CAPTURE(f.id);
    CHECK(f.id != "step.overshoot_mm");
    CHECK(f.id != "step.overshoot_percent");
  }
  Options nowhere;
  nowhere.from_mm = nowhere.reference_mm;
  CHECK(test::figure(nowhere, result, "step.overshoot_percent") == 0);
}

TEST_CASE("gantry: what the thesis shows of an experiment stands in its figure, remark, metrics") {
  struct Shown {
    const char* scenario;
    const char* changed;
    int figure;  // of the thesis; 0: none
    double percent;  // overshoot that it prints, or -1
    bool judged;
  };
  constexpr Shown kShown[] = {{"gantry-p", "", 36, 0.26, true},
                              {"gantry-p", "position.gain=5", 36, 1.31, true},
                              {"gantry-p", "position.gain=6", 0, -1, false},
                              {"gantry-p", "axis.coulomb_count=80", 0, -1, false},
                              {"gantry-p", "run.time_s=2", 36, 0.26, false},
                              {"gantry-p", "step.from_mm=10", 36, 0.26, false},
                              {"gantry-p", "record.every_ms=2", 36, 0.26, true},
                              {"gantry-min-force", "", 35, -1, false},
                              {"gantry-pi", "position.time_shift=8", 37, 71, true},
                              {"gantry-cascade", "", 55, 0, true},
                              {"gantry-home", "", 0, -1, false}};
  for (const Shown& one : kShown) {
    CAPTURE(one.scenario, one.changed);
    const auto settings = lab::load_scenario(lab::find_scenario(one.scenario));
    if (*one.changed != 0) lab::apply_assignment(*settings, one.changed);
    const auto& options = static_cast<const Options&>(*settings);
    for (const auto end : {cosim::EndReason::kDone, cosim::EndReason::kStopped}) {
      Result result;
      result.end = end;
      for (const lab::Figure& f : figures(options, result)) {
        if (f.id != "step.overshoot_percent") continue;
        CHECK(f.printed.value_or(-1) == one.percent);
        CHECK(f.expected.has_value() == (one.judged && end == cosim::EndReason::kDone));
        const std::string source = "Brochier 2006, figure " + std::to_string(one.figure);
        CHECK(f.source == (one.percent < 0 ? "" : source));
      }
    }
    const Lines told = remarks(record_of(options, {}));
    const std::string begin = "Brochier 2006, figure " + std::to_string(one.figure) + ": ";
    CHECK(told.size() == (one.figure == 0 && !options.firmware.home ? 0 : 1));
    if (one.figure != 0) CHECK(told.at(0).rfind(begin, 0) == 0);
    const auto json = metrics_of(options, {});
    CHECK(json["published"].value("figure", 0) == one.figure);
  }
}

TEST_CASE("gantry: remarks tell of homing where it was asked for, of the fit, of bytes heard") {
  const auto told = [](bool home, bool homed, bool fitted, std::size_t bytes) {
    Options options;
    options.scenario = "own";
    options.firmware.home = home;
    Result result;
    result.homed = homed;
    result.fitted = fitted;
    for (std::size_t k = 0; k < bytes; ++k) {
      result.heard.push_back(static_cast<unsigned char>(k == 0 ? 0xAB : k));
    }
    return remarks(record_of(options, std::move(result)));
  };
  CHECK(told(false, false, false, 0) == Lines{});
  CHECK(told(false, true, false, 0) == Lines{});
  CHECK(told(true, true, false, 0) == Lines{"homed"});
  CHECK(told(true, false, false, 0) == Lines{"homing did not end"});
  CHECK(told(true, true, true, 2) == Lines{"homed", "calibration fitted", "heard: AB 01"});
  const std::string most = "heard: AB 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F 10 11 12 13 14 "
                           "15 16 17";
  CHECK(told(false, false, false, 24) == Lines{most});
  CHECK(told(false, false, false, 25) == Lines{most + " ...; all 25 bytes: metrics.json, heard"});
}

TEST_CASE("gantry: metrics have the calibration as the run left it, word for word") {
  Result result;
  for (std::size_t k = 0; k < result.store.size(); ++k) {
    result.store[k] = static_cast<std::uint16_t>(60'000 + 3 * k);
  }
  for (const bool homed : {false, true}) {
    result.homed = homed;
    const auto json = metrics_of({}, result);
    CHECK(json["homed"] == homed);
    REQUIRE(json["calibration"].size() == 64);
    for (std::size_t k = 0; k < 64; ++k) {
      INFO("word " << k);
      CHECK(json["calibration"][k] == 60'000 + 3 * k);
    }
  }
}

TEST_CASE("gantry: the largest speed and force are those of either sign and motor, in any sample") {
  for (const std::size_t at : {std::size_t{0}, std::size_t{4}}) {
    for (const int sign : {1, -1}) {
      for (const std::size_t motor : {std::size_t{0}, std::size_t{1}}) {
        Result result;
        for (std::size_t k = 0; k < 5; ++k) {
          Sample s;
          s.v = k == at ? 0.25 * sign : 0;
          s.words.force[motor] = k == at ? 321 * sign : 0;
          s.force = {999, 999};  // of the motors, not what was written
          result.looks.push_back(s);
        }
        CAPTURE(at, sign, motor);
        CHECK(test::figure(Options{}, result, "max_speed_mm_s") == Approx(250));
        CHECK(test::figure(Options{}, result, "max_force") == 321);
      }
    }
  }
}

TEST_CASE("gantry: arrived and settled are within their bands, on them and on either side") {
  for (const double side : {1.0, -1.0}) {
    const auto figures_at = [&](double off) {
      Options options;
      options.sends = "";  // from 0 on
      options.time_s = 0.01;
      options.zero_mm = -2;
      options.from_mm = 100;
      options.reference_mm = 200;
      options.band_mm = 1;
      Result result;
      for (int k = 0; k < 2; ++k) {
        Sample s;
        s.edge = 50'000 * (k + 1);
        s.x = 1e-3 * (198 + (k == 0 ? 50 : side * off));
        result.looks.push_back(s);
      }
      return step_figures(options, result);
    };
    CAPTURE(side);
    CHECK(figures_at(0.99).arrive_s == Approx(2e-3));
    CHECK(figures_at(1.01).arrive_s < 0);
    CHECK(figures_at(1.99).settle_s == Approx(2e-3));
    CHECK(figures_at(2.01).settle_s < 0);
    CHECK(figures_at(3).rest_mm == Approx(3 * side));
    CHECK(figures_at(3).overshoot_mm == Approx(50));
  }
}

TEST_CASE("gantry: a time that never was is no figure, and a remark says so with its band") {
  Options options;
  options.scenario = "own";
  options.sends = "";
  options.band_mm = 2;
  const auto told = [&](double last_mm) {
    Result result;
    for (const double mm : {0.0, 304.0, last_mm}) {
      Sample s;
      s.edge = 50'000 * static_cast<cosim::Clk>(result.looks.size() + 1);
      s.x = 1e-3 * (last_mm < 200 && mm > 0 ? last_mm : mm);
      result.looks.push_back(s);
    }
    std::string ids;
    CHECK(step_figures(options, result).overshoot_mm == 0);
    for (const lab::Figure& f : figures(options, result)) {
      CHECK_FALSE((f.unit == "s" && f.value < 0));
      if (f.unit == "s") ids += f.id + ' ';
    }
    for (const std::string& line : remarks(record_of(options, std::move(result)))) ids += line;
    return ids;
  };
  CHECK(told(304) == "step.arrive_s step.settle_s ");
  CHECK(told(290) == "step.arrive_s the cart is not within 6.1 mm (2 %) of 305 mm at the end");
  CHECK(told(100) == "the cart was never within 2 mm of 305 mm (step.band_mm)");
}

TEST_CASE("gantry: each figure of a step is from its command on, in either sense") {
  for (const bool back : {false, true}) {
    Options options;
    options.sends = "0.05:31? 0.1:21=300";
    options.time_s = 1.1;
    options.from_mm = back ? 300 : 0;
    options.reference_mm = back ? 0 : 300;
    options.zero_mm = -2;
    options.band_mm = 4;
    Result result = by_hand(options);
    const double sense = back ? -1 : 1;
    const std::map<std::string, double> expected{
        {"step.overshoot_mm", 30},  {"step.overshoot_percent", 10},
        {"step.arrive_s", 0.2},     {"step.settle_s", 0.42},
        {"step.rest_mm", -3 * sense}, {"step.swing_mm", 2},
        {"max_speed_mm_s", 400},    {"max_force", 700},
        {"passes", 11},             {"host.heard", 3},
        {"host.malformed", 4},      {"host.lost", 5},
        {"host.unknown", 6},         {"host.unchecked", 0},
        {"host.refused", 0},        {"host.unsent", 0}};
    std::size_t seen = 0;
    for (const lab::Figure& f : gantry::figures(options, result)) {
      INFO("figure " << f.id << (back ? ", back" : ""));
      REQUIRE(expected.count(f.id) == 1);
      CHECK(f.value == Approx(expected.at(f.id)));
      ++seen;
    }
    CHECK(seen == expected.size());
  }
}

TEST_CASE("gantry: each column of the trace shows what it is named after") {
  Result result;
  Sample s;
  s.edge = 150'000;
  s.words.position = 16384;  // a period of 5 mm
  s.words.velocity = 512;    // a unit a tick of 4612 Hz
  s.words.phase = 101;
  s.words.codes = {11, 12, 13, 14, 15};
  s.words.force = {21, -22};
  s.x = 0.031;
  s.v = 0.032;
  s.motor = {0.041, 0.042};
  s.force = {51.5, -52.5};
  s.flank = {1, -1};
  s.error = 61;
  s.goal = 62;
  s.zero = 2;
  s.origin = 0.15;
  s.velocity = 1024;
  s.phase = 4;
  s.stripes = {71, 72};
  result.samples.push_back(s);
  const double unit_mm_s = 5.0 / 16384 * 4612;
  test::check_row(test::row(Options{}, result, 0),
                  {{"t_s", 3e-3}, {"x_mm", 31}, {"v_mm_s", 32}, {"position_mm", 5},
                   {"goal_mm", 10}, {"origin_mm", 150}, {"velocity_mm_s", unit_mm_s},
                   {"filtered_mm_s", 2 * unit_mm_s},
                   {"error_count", 61}, {"phase", 4}, {"angle", 101}, {"a_code", 11},
                   {"b_code", 13}, {"sensor_a_code", 71}, {"sensor_b_code", 72},
                   {"m1_u_count", 21}, {"m2_u_count", -22},
                   {"m1_force_count", -51.5}, {"m2_force_count", 52.5}, {"m1_apart_mm", 41},
                   {"m2_apart_mm", 42}, {"m1_flank", 1}, {"m2_flank", -1}});
}
