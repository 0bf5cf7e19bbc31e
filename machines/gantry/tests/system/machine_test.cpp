// SPDX-License-Identifier: Apache-2.0
//
// The machine gantry: acceptance tests G-04 to G-10, G-13, G-14 and G-16, each by the RTL or, where
// several runs are compared, by its bit-exact twin; equal events in every wiring.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "machines/gantry/tests/steps.hpp"
#include "tests/support/wirings.hpp"

using namespace trammel;
using gantry::Options;
using gantry::Result;
using gantry::Sample;
using gantry::StepFigures;
using namespace gantry_test;

TEST_CASE("G-04 a poll of channel 31 is answered by the whole configuration and its end") {
  Options options = built_in("gantry-p", cosim::Engine::kRtl);
  options.sends = "0.05:31?";
  options.time_s = 0.1;
  const Result result = done(options);
  const std::vector<unsigned char> expected{
      0x8A, 0x49,                                                        // the reset message
      0x82, 0x88, 0x1F, 0x82, 0x88, 0x3F, 0xB2, 0xA8, 0x1F,              // DI0, DI1, ENC0
      0x94, 0x98, 0x3F, 0xD8, 0x3F, 0x81, 0xA1, 0x98, 0x3F,              // AI1 and its bounds
      0x94, 0x98, 0x5F, 0xD8, 0x5F, 0x81, 0xA1, 0x98, 0x5F,              // AI2
      0x94, 0x99, 0x3F, 0xD9, 0x3F, 0x81, 0xA1, 0x99, 0x3F,              // AI5
      0x94, 0x99, 0x5F, 0xD9, 0x5F, 0x81, 0xA1, 0x99, 0x5F,              // AI6
      0x90, 0x98, 0x7F, 0xD8, 0x7F, 0x81, 0xA1, 0x98, 0x7F,              // AI3
      0xAE, 0xA9, 0x1F, 0x96, 0xA0, 0x1F,                                // ENC4, AO0
      0x83, 0x90, 0xE0, 0x1F, 0x83, 0x81, 0xA0, 0x1F, 0x80, 0x1F};       // its bounds, the end
  CHECK(result.heard == expected);
}

TEST_CASE("polls of every channel are answered, other channels are counted, garbage is dropped") {
  Options options = built_in("gantry-p", cosim::Engine::kRtl);
  options.sends = "0.05:0? 0.06:1? 0.06:2? 0.06:5? 0.06:6? 0.07:3? 0.08:4? 0.09:d0? 0.09:d1?";
  options.time_s = 0.12;
  const Result result = done(options);
  std::vector<unsigned> channels;
  for (const unsigned char byte : result.heard) {
    if ((byte & 0x80) == 0) channels.push_back(byte & 31u);
  }
  // Those of one conversion slot after the other come as the slots have them.
  CHECK(channels == std::vector<unsigned>{9, 0, 1, 2, 6, 5, 3, 4, 0, 1});
  options.sends = "0.05:15? 0.06:17=3 0.07:d2? 0.08:xFFFFFFFFFFFFFF00 0.1:0?";
  const Result bad = lab::simulate(options);
  CHECK(bad.unknown == 3);
  CHECK(bad.malformed == 1);
  CHECK((bad.heard.back() & 0x9F) == 0);  // the poll behind the overlong frame
}

TEST_CASE("G-05 with MIN = 50h the cart stops at least 2 mm short for ever, with 80h it arrives") {
  Options options = built_in("gantry-min-force");
  options.time_s = 6;
  CHECK(step_of(options).rest_mm < -2);
  options.firmware.position.least = 0x80;
  CHECK(std::fabs(step_of(options).rest_mm) < 1);
}

TEST_CASE("G-06 P, K = 3: overshoot 0.05 to 0.5 %, at 304 mm within a second and before K = 2") {
  Options options = built_in("gantry-p", cosim::Engine::kRtl);
  const StepFigures three = step_of(options);
  CHECK(three.overshoot_mm > 0.0005 * 305);
  CHECK(three.overshoot_mm < 0.005 * 305);
  CHECK(three.arrive_s > 0);
  CHECK(three.arrive_s < 1);
  options.firmware.position.gain = 2;
  options.run.engine = cosim::Engine::kTwin;
  CHECK(step_of(options).arrive_s > three.arrive_s);
}

TEST_CASE("G-07 PI, TI = 9, half a step: 45 % of overshoot within 8 points, the order of TI") {
  Options options = built_in("gantry-pi");
  const double nine = percent(options);
  CHECK(nine == Approx(45).margin(8));
  options.firmware.position.time = 8;
  CHECK(percent(options) > nine);
  options.firmware.position.time = 10;
  CHECK(percent(options) < nine);
}

TEST_CASE("G-08 PI with anti-windup, TI = 12: 0.65 % within 0.4 points") {
  CHECK(percent(built_in("gantry-pi-aw")) == Approx(0.65).margin(0.4));
}

TEST_CASE("G-09 cascade, K = 9: less than a count of overshoot at 30 and 305 mm, slower than P") {
  const Options small = built_in("gantry-cascade-30");
  CHECK(step_of(small).overshoot_mm < kCount_mm);
  const StepFigures large = step_of(built_in("gantry-cascade", cosim::Engine::kRtl));
  CHECK(large.overshoot_mm < kCount_mm);
  CHECK(large.arrive_s > step_of(built_in("gantry-p")).arrive_s);
}

// The sum of the velocity PI is 0 here, as after power-on. Behind a long approach it is wound up
// against the brake, and the compensated cart turns later: machines/gantry/README.md.
TEST_CASE("G-10 backlash: +112 and -112 at rest, a count of overshoot, the cart starts earlier") {
  Options options = built_in("gantry-backlash");
  double began[2] = {0, 0};
  for (const bool compensate : {false, true}) {
    options.firmware.compensate = compensate;
    const Result result = done(options);
    CHECK(gantry::step_figures(options, result).overshoot_mm <= kCount_mm);
    for (const Sample& s : result.samples) {
      if (compensate && std::fabs(time_of(s) - 0.9) < 1e-4) {
        CHECK(s.words.force[0] == 112);
        CHECK(s.words.force[1] == -112);
        CHECK(s.flank[0] * s.flank[1] == -1);  // they hold the cart from both sides
      }
      if (began[compensate] == 0 && s.x > options.axis.start + 2e-5) began[compensate] = time_of(s);
    }
    REQUIRE(began[compensate] > 1);
    if (!compensate) continue;
    const Sample last = result.samples.back();
    CHECK(last.error == 0);
    CHECK(last.words.force[0] == 112);
    CHECK(last.words.force[1] == -112);
    // What is asked and where the cart is, from the track's zero: the run began at 150 mm.
    CHECK(1e3 * last.origin + kCount_mm * (last.goal + last.zero) == Approx(155).margin(0.2));
    const double counted = 5.0 / 16384 * last.words.position;
    CHECK(1e3 * last.origin + counted == Approx(1e3 * last.x).margin(0.01));
  }
  CHECK(began[1] < began[0]);
}

TEST_CASE("G-13 power-on: the reset message first, then to the right stop, and zero is there") {
  const Options options = built_in("gantry-home", cosim::Engine::kRtl);
  const Result result = done(options);
  REQUIRE(result.heard.size() == 2);
  CHECK(result.heard[0] == 0x8A);
  CHECK(result.heard[1] == 0x49);
  CHECK(result.homed);
  const Sample last = result.samples.back();
  CHECK(1e3 * last.x == Approx(-2).margin(0.3));
  double began = 0, ended = 0;
  for (const Sample& s : result.samples) {
    if (began == 0 && std::fabs(1e3 * s.x + 2) < 0.3) began = time_of(s);
    if (ended == 0 && s.phase == static_cast<int>(sw::GantryPhase::kPosition)) ended = time_of(s);
  }
  CHECK(ended - began == Approx(20000 / 4612.0).margin(0.2));  // it swings at the stop
  CHECK(std::abs(last.error) <= 2);
}

TEST_CASE("G-14 velocity 1000: mean error below 5 % in the zones of friction, and no stop") {
  struct Zone {
    double start, from, to, time;
  };
  for (const Zone& zone : {Zone{0.080, 0.090, 0.110, 14}, Zone{0.210, 0.220, 0.290, 32}}) {
    Options options = built_in("gantry-friction");
    options.axis.start = zone.start;
    options.time_s = zone.time;
    const Result result = done(options);
    double first = -1, last = 0, way = 0, slowest = 1;
    for (const Sample& s : result.samples) {
      if (time_of(s) > 3.1) slowest = std::min(slowest, s.v);
      if (s.x < zone.from || s.x > zone.to) continue;
      if (first < 0) {
        first = time_of(s);
        way = s.x;
      }
      last = time_of(s);
    }
    const double speed = (zone.to - way) / (last - first), asked = 2.748e-6 * 1000;
    CAPTURE(zone.from);
    CHECK(speed == Approx(asked).epsilon(0.05));
    CHECK(slowest > 0);
  }
}

TEST_CASE("G-16 PI with a cancelled sum: 4.5 % within a point for TI of 5, 7, 10 and 12") {
  Options options = built_in("gantry-pi-cancel");
  for (const int time : {5, 7, 10, 12}) {
    options.firmware.position.time = time;
    CAPTURE(time);
    CHECK(percent(options) == Approx(4.5).margin(1));
  }
}

TEST_CASE("a converter that sticks or browns out, no supply: noticed where it is watched") {
  Options options = built_in("gantry-p");
  options.time_s = 1;
  options.fault.kind = cosim::FaultKind::kConverterStuck;  // A, at 0.3 s
  options.fault.begin_s = 0.3;
  const Result blind = lab::simulate(options);
  CHECK(blind.end == cosim::EndReason::kMissed);  // by the track's truth, not by the firmware
  CHECK(blind.fault.rfind("the observer has lost a stripe: at 0.3", 0) == 0);
  CHECK(blind.fault_report.by == "");
  options.firmware.stall_ticks = 230;
  const Result stuck = lab::simulate(options);
  CHECK(stuck.end == cosim::EndReason::kFault);
  CHECK(stuck.fault == "a force and no motion");
  CHECK(std::fabs(stuck.samples.back().v) < 1e-3);  // it came to rest,
  CHECK(stuck.samples.back().edge < options.run.clocks(0.6));  // and no more
  CHECK(stuck.samples.back().x < 0.3);
  options.firmware.stall_ticks = 0;
  options.firmware.watch_sensor = true;
  options.fault.kind = cosim::FaultKind::kConverterSaturated;
  options.fault.value = -1;
  const Result brown = lab::simulate(options);
  CHECK(brown.end == cosim::EndReason::kFault);
  CHECK(brown.fault == "A and B are not on their circle");
  options.fault.kind = cosim::FaultKind::kSupplyDip;
  options.fault.value = 0;
  options.fault.begin_s = 0.05;
  options.firmware.watch_sensor = false;
  options.firmware.stall_ticks = 460;
  const Result still = lab::simulate(options);
  CHECK(still.fault == "a force and no motion");
}

TEST_CASE("the calibration run fits a sensor with errors of 2 %, the next step ends there") {
  const Options options = built_in("gantry-calibrate");
  const Result result = done(options);
  CHECK(result.fitted);
  CHECK(std::equal(result.fit.begin(), result.fit.end(), result.store.begin()));
  const Sample last = result.samples.back();
  CHECK(std::abs(last.error) <= 2);
  CHECK(1e3 * last.x + 2 == Approx(305).margin(0.5));
}

// The line, the chip and the firmware: gantry.long, in the full tier.
TEST_CASE("a million bytes of any kind, then the track does as it is told", "[.million]") {
  Options options = built_in("gantry-p", cosim::Engine::kRtl);
  std::string bytes;
  std::uint64_t state = 29;
  for (int k = 0; k < 1'000'000; ++k) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const auto any = static_cast<unsigned>(state >> 33);
    bytes += fmt::format("{:02X}", any % 5 == 0 ? any >> 8 & 0x7F : any >> 8 & 0xFF);
  }
  // Then the end of a frame, the whole observer, and a place.
  options.sends = "0.05:x" + bytes + "00 90:11=17 90.1:12=8 90.2:12=6 91:21=2 93:0?";
  options.time_s = 93.1;
  options.run.max_s = 100;
  options.record_ms = 10;
  const Result result = lab::simulate(options);
  // Among them are masks and slots of the observer, which loses the track meanwhile.
  CHECK(result.end == cosim::EndReason::kMissed);
  CHECK_THAT(result.fault, Catch::Contains("lost a stripe"));
  CHECK_FALSE(result.assertion);
  CHECK(result.malformed > 5'000);
  CHECK(result.unknown > 100'000);
  CHECK(result.heard.size() > 100'000);
  CHECK((result.heard.back() & 31u) == 0);  // the answer to the poll
  CHECK(std::abs(result.samples.back().error) <= 2);
  CHECK(std::equal(result.store.begin(), result.store.end(), gantry::ideal_store().begin()));
}

TEST_CASE("gantry: every wiring gives the record of the leaping RTL, and --audit no difference") {
  Options plain = built_in("gantry-p", cosim::Engine::kRtl);
  plain.time_s = 0.12;
  plain.firmware.stream = true;
  plain.sends = "0.02:21=305 0.03:31?";
  const Result first = test::check_wirings(plain);
  CHECK(first.end == cosim::EndReason::kDone);
  CHECK(first.evaluated < first.clocks / 10);
}
