// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine gantry tells of a fault and of its current, at either end and of either
// motor.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <exception>
#include <string>

#include "lab/record.hpp"
#include "machines/gantry/machine.hpp"
#include "machines/gantry/plant.hpp"
#include "machines/gantry/tests/by_twin.hpp"

using namespace trammel;
using namespace trammel::gantry;
using Catch::Contains;

TEST_CASE("gantry: a run with a fault tells whether the cart came to a stop, at either end") {
  struct Case {
    const char* where;
    double start_m;
    bool home;          // to the lower stop
    const char* sends;  // counted from where it starts
    bool at_stop;
  };
  for (const Case& one : {Case{"lower stop", 0.02, true, "", true},
                          Case{"upper stop", 0.43, false, "0.05:21=100", true},
                          Case{"between them", 0.2, false, "0.05:21=30", false}}) {
    Options options = by_twin(0.5);
    options.axis.start = one.start_m;
    options.firmware.home = one.home;
    options.sends = one.sends;
    options.fault.kind = cosim::FaultKind::kSupplyDip;
    options.fault.value = 99;  // per cent remain: it harms nothing
    const Result result = lab::simulate(options);
    double low = 1, high = 0;
    for (const Sample& s : result.samples) {
      low = std::min(low, s.x);
      high = std::max(high, s.x);
    }
    CAPTURE(one.where, low, high, options.axis.stop_low, options.axis.stop_high);
    CHECK((low < options.axis.stop_low) == (one.home));
    CHECK((high > options.axis.stop_high) == (one.at_stop && !one.home));
    CHECK(result.fault_report.at_stop == one.at_stop);
  }
}

TEST_CASE("gantry: the current is that of both motors, pull they together or apart") {
  for (const int first : {-1, 0, 1}) {
    for (const int second : {-1, 0, 1}) {
      TrackPlant plant({}, {}, {}, false);
      cosim::Lines drive = cosim::Lines{1} << kTx;
      for (const auto& [motor, force] : {std::pair{0, first}, {1, second}}) {
        if (force != 0) drive |= cosim::Lines{1} << pwm(motor);
        if (force < 0) drive |= cosim::Lines{1} << negative(motor);
      }
      plant.commit(1, drive);
      while (plant.next() <= 500'000) plant.commit(plant.next(), drive);  // 20 time constants
      const int sides = (first != 0 ? 1 : 0) + (second != 0 ? 1 : 0);
      const auto& force = plant.axis().state().force;
      CAPTURE(first, second, force[0], force[1]);
      CHECK(plant.sample(kCurrent, 500'000) == Approx(511.5 * sides).margin(1));
      CHECK(force[0] == Approx(-1023 * first).margin(1));  // negative: the position increases
      CHECK(force[1] == Approx(-1023 * second).margin(1));
    }
  }
}

TEST_CASE("gantry: a fault is noticed by what chip and program count, and names it") {
  for (const auto& [sends, by] : {std::pair{"0.02:15?", "unknown channel"},
                                  {"0.02:xFFFFFFFFFFFFFF00", "malformed frame"},
                                  {"0.02:31?", ""}}) {
    Options options = by_twin(0.05);
    options.sends = sends;
    options.fault.kind = cosim::FaultKind::kSupplyDip;
    options.fault.value = 99;
    const Result result = lab::simulate(options);
    CAPTURE(sends);
    CHECK(result.fault_report.by == by);
    const bool noticed = result.fault_report.detected != cosim::kNever;
    CHECK(noticed == (*by != '\0'));
    if (noticed) {
      CHECK(lab::seconds_of(result.fault_report.detected) == Approx(0.0203).margin(1e-3));
    }
  }
}

TEST_CASE("gantry: how far a cart went once its motors were off is told in mm") {
  Options options = by_twin(5);
  options.sends = "0.01:21=305";
  options.firmware.watch_sensor = true;
  options.fault.kind = cosim::FaultKind::kConverterSaturated;
  options.fault.begin_s = 0.15;
  options.fault.value = -1;
  const Result result = lab::simulate(options);
  const cosim::FaultReport& report = result.fault_report;
  REQUIRE(report.off != cosim::kNever);
  double off_mm = 0;
  for (const Sample& s : result.samples) {
    if (s.edge <= report.off) off_mm = 1e3 * s.x;
    if (s.edge > report.off) CHECK(s.words.force == std::array<std::int32_t, 2>{0, 0});
  }
  const double way = 1e3 * result.samples.back().x - off_mm;
  CHECK(way > 1);
  CHECK(report.stopping == Approx(way).margin(0.5));
  CHECK_FALSE(report.at_stop);
}

TEST_CASE("gantry: a fault is on the serial line, on either converter and each of its outputs") {
  const auto told = [](cosim::FaultKind kind, int axis, int line, int value) {
    Options options = by_twin(1e-3);
    options.fault.kind = kind;
    options.fault.axis = axis;
    options.fault.line = line;
    options.fault.value = value;
    try {
      lab::simulate(options);
    } catch (const std::exception& refused) {
      return std::string(refused.what());
    }
    return std::string();
  };
  using Kind = cosim::FaultKind;
  CHECK(told(Kind::kEncoderStuck, 0, 0, -1) == "");
  CHECK(told(Kind::kEncoderStuck, 1, 0, -1) == "");
  CHECK(told(Kind::kConverterStuck, 1, 1, 1023) == "");
  CHECK_THAT(told(Kind::kConverterStuck, 0, 2, 0), Contains("inject.line"));
  CHECK(told(Kind::kOutputStuck, 1, 1, 0) == "");
  CHECK_THAT(told(Kind::kOutputStuck, 0, 2, 0), Contains("inject.line"));
  CHECK_THAT(told(Kind::kRegisterFlip, 0, 0, 0), Contains("inject.fault: register_flip"));
}
