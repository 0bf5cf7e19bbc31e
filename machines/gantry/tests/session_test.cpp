// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine gantry tells of faults and of its current, at either end and of either
// motor: what it does, by what it is noticed.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <string>
#include <utility>

#include "lab/record.hpp"
#include "machines/gantry/machine_members.hpp"
#include "machines/gantry/plant.hpp"
#include "machines/gantry/tests/by_twin.hpp"
#include "tests/support/figures.hpp"

using namespace trammel;
using namespace trammel::gantry;

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

TEST_CASE("gantry: an open motor pulls no more, the other one does, until it is closed") {
  for (const std::size_t dead : {std::size_t{0}, std::size_t{1}}) {
    TrackPlant plant({}, {}, {}, false);
    const cosim::Lines drive =
        cosim::Lines{1} << kTx | cosim::Lines{1} << pwm(0) | cosim::Lines{1} << pwm(1);
    const auto go = [&](cosim::Clk end) {
      while (plant.next() < end) plant.commit(plant.next(), drive);
      plant.commit(end, drive);
    };
    const auto& force = plant.axis().state().force;
    plant.commit(1, drive);
    plant.open_phase(1, static_cast<int>(dead), 0, true);
    go(500'000);  // 20 time constants
    CAPTURE(dead);
    CHECK(force[dead] == Approx(0).margin(1));
    CHECK(force[1 - dead] == Approx(-1023).margin(1));
    plant.open_phase(500'000, static_cast<int>(dead), 0, false);
    go(1'000'000);
    CHECK(force[dead] == Approx(-1023).margin(1));
    plant.supply(1'000'000, 0.25);
    go(1'500'000);
    CHECK(force[0] == Approx(-1023 * 0.25).margin(1));
    CHECK(force[1] == Approx(-1023 * 0.25).margin(1));
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

TEST_CASE("gantry: a run whose homing, or calibration run, has not ended has missed") {
  for (const auto& [time_s, why] : {std::pair{0.3, "homing did not end"},
                                    {1.5, "the calibration run did not end"}, {0.6, ""}}) {
    Options options = by_twin(time_s);
    options.sends = "";
    options.axis.start = 0.01;
    options.firmware.home = true;
    options.firmware.home_ticks = 100;
    options.firmware.calibrate = time_s > 1;
    const Result result = lab::simulate(options);
    CAPTURE(time_s);
    CHECK(result.fault == why);
    CHECK(result.end == (*why ? cosim::EndReason::kMissed : cosim::EndReason::kDone));
  }
}

TEST_CASE("gantry: a run whose sensor errors cost the observer a stripe has missed") {
  for (const double share : {0.0, -0.15}) {  // within their range, and all at once
    Options options = by_twin(0.4);
    plant::StripeTrackConfig& s = options.stripes;
    s.amplitude_a_error = s.amplitude_b_error = share;
    s.offset_a_error = s.offset_b_error = s.phase_b_error = share;
    const Result result = lab::simulate(options);
    CAPTURE(share, result.fault);
    const bool lost = share != 0;
    CHECK(result.end == (lost ? cosim::EndReason::kMissed : cosim::EndReason::kDone));
    CHECK((result.fault.rfind("the observer has lost a stripe: at 0.1", 0) == 0) == lost);
  }
}

TEST_CASE("gantry: figures, answers and verdict do not depend on the raster of the record") {
  const auto told = [](double every_ms, double max_s) {
    Options options = by_twin(0.5004);
    options.sends = "0.05:21=20 0.2:31? 0.49:0?";
    options.reference_mm = 20;
    options.firmware.stream = true;
    options.record_ms = every_ms;
    options.run.max_s = max_s;
    return test::record_text(lab::run(options));
  };
  const std::string fine = told(1, 2);
  CHECK_THAT(fine, Catch::StartsWith("done step.overshoot_mm="));
  for (const double every_ms : {0.3, 7.3, 100.0, 1000.0}) {
    CAPTURE(every_ms);
    CHECK(told(every_ms, 2) == fine);
  }
  CHECK(told(100, 0.51) == fine);  // the experiment is whole, the record is cut
}

TEST_CASE("gantry: a run whose longest time is that of its experiment is done") {
  Options options = by_twin(0.05);
  options.sends = "";
  options.run.max_s = options.time_s;
  CHECK(lab::simulate(options).end == cosim::EndReason::kDone);
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
      CHECK(result.seconds(result.fault_report.detected) == Approx(0.0203).margin(1e-3));
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

TEST_CASE("gantry: a fault of the line silences it, over-temperature is that of either motor") {
  using Kind = cosim::FaultKind;
  const auto heard = [](Kind kind, int axis, int line) {
    Options options = by_twin(0.1);
    options.sends = "0.05:d0? 0.06:d1?";
    options.fault.kind = kind;
    options.fault.axis = axis;
    options.fault.line = line;
    options.fault.value = kind == Kind::kSupplyDip ? 99 : line == 0 ? -1 : 1;
    options.fault.begin_s = 0.02;
    return lab::simulate(options).heard;
  };
  const auto whole = heard(Kind::kSupplyDip, 0, 0);
  REQUIRE(whole.size() == 4);  // the reset message, and an answer of a byte to each
  for (const int axis : {0, 1}) {
    CAPTURE(axis);
    CHECK(heard(Kind::kEncoderStuck, axis, 0).size() == 2);
    const auto hot = heard(Kind::kEncoderStuck, axis, 1);
    REQUIRE(hot.size() == 4);
    CHECK(hot[2] == (axis == 0 ? 0x20 : 0x00));  // a bit of channel 0, set or clear
    CHECK(hot[3] == (axis == 1 ? 0x21 : 0x01));
  }
}

TEST_CASE("gantry: frames that come while the processor stands are counted as lost") {
  Options options = by_twin(0.1);
  options.sends.clear();
  for (int k = 0; k < 60; ++k) options.sends += "0.05:1? ";
  options.fault.kind = cosim::FaultKind::kProcessorStopped;
  options.fault.begin_s = 0.02;
  const Result result = lab::simulate(options);
  CAPTURE(result.lost, result.malformed, result.unknown);
  CHECK(result.lost > 0);
  CHECK(result.lost < 60);
  CHECK(result.malformed == 0);
  CHECK(result.unknown == 0);
  CHECK(result.passes < 12);
}
