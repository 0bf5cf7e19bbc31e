// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine gantry tells of a fault and of its current, at either end and of either
// motor.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "lab/record.hpp"
#include "machines/gantry/machine.hpp"
#include "machines/gantry/plant.hpp"
#include "machines/gantry/tests/by_twin.hpp"

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
    const lab::Record record = lab::run(options);
    std::string all = record.verdict;
    for (const lab::Figure& f : record.figures) all += fmt::format(" {}={}", f.id, f.value);
    for (const std::string& line : remarks(record)) all += line;
    nlohmann::ordered_json json;
    add_metrics(record, json);
    return all + json.dump();
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
