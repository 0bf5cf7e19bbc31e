// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine gantry is judged by and what its trace shows, from records by hand.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <string>

#include "machines/gantry/machine.hpp"
#include "tests/support/figures.hpp"

using namespace trammel;
using gantry::Options;
using gantry::Result;
using gantry::Sample;

namespace {

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

TEST_CASE("gantry: a cart that never comes near has not arrived, one that leaves has not settled") {
  Options options;
  options.sends = "0:21=300";
  options.time_s = 0.01;
  options.reference_mm = 300;
  Result result;
  const auto put = [&](int ms, double mm) {
    Sample s;
    s.edge = ms * kMs;
    s.x = 1e-3 * mm;
    result.looks.push_back(s);
  };
  for (int ms = 0; ms < 5; ++ms) put(ms, 200);
  CHECK(gantry::step_figures(options, result).arrive_s < 0);
  CHECK(gantry::step_figures(options, result).settle_s < 0);
  for (int ms = 5; ms < 8; ++ms) put(ms, 299.5);
  CHECK(gantry::step_figures(options, result).arrive_s == Approx(0.005));
  CHECK(gantry::step_figures(options, result).settle_s == Approx(0.005));
  put(8, 280);
  CHECK(gantry::step_figures(options, result).arrive_s == Approx(0.005));
  CHECK(gantry::step_figures(options, result).settle_s < 0);
  CHECK(gantry::step_figures(options, result).overshoot_mm == 0);
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
