// SPDX-License-Identifier: Apache-2.0
//
// The table of the machine larson behind its pins, whole and with a fault: each switch and buffer
// on its own line, a dead phase and a weak supply, and what a run tells of them.
#include <catch2/catch.hpp>
#include <array>
#include <cmath>

#include "machines/larson/plant.hpp"
#include "machines/larson/session.hpp"
#include "machines/larson/tests/scripted.hpp"
#include "tests/support/event_record.hpp"
#include "tests/support/session_run.hpp"

using namespace trammel;
using namespace trammel::larson;

namespace {

constexpr cosim::Lines kOne = 1;

// 200 pulses at 2000 PPS, forward, to both axes, and until they have come.
void turn(TablePlant& plant, cosim::Clk from) {
  const cosim::Lines rest = kOne << forward(0) | kOne << forward(1);
  cosim::Lines last = rest;
  const auto put = [&](cosim::Clk n, cosim::Lines drive) {
    while (plant.next() < n) plant.commit(plant.next(), last);
    plant.commit(n, drive);
    last = drive;
  };
  for (cosim::Clk k = 0; k < 200; ++k) {
    put(from + 25'000 * k, rest | kOne << step(0) | kOne << step(1));
    put(from + 25'000 * k + 100, rest);
  }
  put(from + 20'000'000, rest);
}

plant::StepperAxisConfig weak_motor() {
  plant::StepperAxisConfig c;
  c.motor.damping_2 = c.motor.damping_3 = 0.5;
  c.motor.friction = 0.21;     // [N m]
  c.motor.torque_share = 0.9;  // 0.26 N m at rest and 0.28 at 2000 PPS; three fifths are less
  return c;
}

}  // namespace

TEST_CASE("larson: each switch and each buffer is on its own line and its own bit") {
  const plant::StepperAxisConfig between;
  for (int k = 0; k < 2; ++k) {
    for (const bool high : {false, true}) {
      plant::StepperAxisConfig at = between;
      at.start = high ? at.switch_high + at.switch_hysteresis + 1
                      : at.switch_low - at.switch_hysteresis - 1;
      const TablePlant plant(k == 0 ? at : between, k == 0 ? between : at);
      CAPTURE(k, high);
      CHECK(plant.sense() == kOne << (high ? limit_high(k) : limit_low(k)));
      CHECK(plant.switches() == 1u << (2 * k + (high ? 1 : 0)));
    }
    TablePlant plant(between, between);
    CHECK(plant.sense() == 0);
    cosim::Lines seen = 0;
    cosim::Clk n = 1;
    for (int pulse = 0; pulse < 8; ++pulse, n += 200) {
      plant.commit(n, kOne << step(k));
      plant.commit(n + 100, 0);
    }
    for (; plant.next() < 5'000'000; seen |= plant.sense()) plant.commit(plant.next(), 0);
    CAPTURE(k);
    CHECK(seen == kOne << buf_busy(k));
  }
}

TEST_CASE("larson: a dead phase weakens its own axis until it is whole, a supply both of them") {
  for (int axis = 0; axis < 2; ++axis) {
    for (const bool mended : {false, true}) {
      TablePlant plant(weak_motor(), weak_motor());
      plant.open_phase(1, axis, 3, true);
      if (mended) plant.open_phase(2, axis, 3, false);
      turn(plant, 1000);
      for (int k = 0; k < 2; ++k) {
        CAPTURE(axis, mended, k);
        CHECK(plant.axis(static_cast<std::size_t>(k)).lost().empty() == (mended || k != axis));
      }
    }
  }
  for (const double share : {0.6, 1.0}) {
    TablePlant plant(weak_motor(), weak_motor());
    plant.supply(1, share);
    turn(plant, 1000);
    CAPTURE(share);
    CHECK(plant.axis(0).lost().empty() == (share == 1));
    CHECK(plant.axis(1).lost().empty() == (share == 1));
  }
}

TEST_CASE("larson: how far a table went once nothing drove it is told in steps, of either axis") {
  for (const int axis : {0, 1}) {
    // Its switch never opens: CALTBL gives up behind 2000 steps.
    ScriptedTwin script("CALTBL\n");
    script.options.record_ms = 0.1;
    script.options.table.back_rate = 2000;
    script.options.axis.motor.damping_2 = script.options.axis.motor.damping_3 = 0;  // it rings
    script.options.fault.kind = cosim::FaultKind::kEncoderStuck;
    script.options.fault.axis = axis;
    script.options.fault.value = 1;
    const auto run = test::record_run<Session, Result>(script.options);
    const cosim::FaultReport& report = run.result.fault_report;
    CAPTURE(axis, run.result.fault, report.by);
    REQUIRE(report.by == "CALTBL");
    REQUIRE(report.off != cosim::kNever);
    CHECK(report.unit == "step");
    std::array<double, 2> off{}, last{};
    for (const Sample& s : run.result.samples) {
      for (std::size_t k = 0; k < 2; ++k) {
        if (s.edge <= report.off) off[k] = s.axis[k].at;
        last[k] = s.axis[k].at;
      }
    }
    const double way = std::hypot(last[0] - off[0], last[1] - off[1]);
    CHECK(way > 0.5);
    CHECK(report.stopping == Approx(way).margin(0.25));
  }
}

TEST_CASE("larson: the engine that a run asks for is the one that it has") {
  ScriptedTwin script("VELTBL 500 500\n");
  script.options.run.max_s = 1e-3;
  test::check_engines<Session>(script.options, [] { return make_twin_chip({}); });
}
