// SPDX-License-Identifier: Apache-2.0

#include <Vsupervisor.h>

#include <catch2/catch.hpp>

#include "models/exact/drive/gate_leg.hpp"
#include "models/exact/drive/supervisor.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Supervisor;
using Fault = Supervisor::Fault;
using In = Supervisor::In;
using trammel::test::Random;
using Rtl = trammel::test::Rtl<Vsupervisor>;

namespace {

unsigned char bits(const std::array<bool, 2>& of) {
  return static_cast<unsigned char>(of[0] + 2 * of[1]);
}

void apply(Rtl& rtl, const In& in) {
  rtl->tick_count_i = in.tick_count;
  rtl->enabled_i = bits(in.enabled);
  rtl->clear_i = in.clear;
  rtl->trip_pin_i = in.trip_pin;
  rtl->over_current_i = bits(in.over_current);
  rtl->watchdog_i = in.watchdog;
  rtl->encoder_i = bits(in.encoder);
  rtl->stroke_i = bits(in.stroke);
  rtl.eval();
}

void step(Rtl& rtl, const In& in) {
  apply(rtl, in);
  rtl.tick();
}

}  // namespace

TEST_CASE("supervisor agrees with its twin on random causes, clears and resets") {
  Rtl rtl;
  Supervisor twin;
  rtl.reset();
  Random random(4);
  const auto rare = [&random] { return random() % 16 == 0; };
  In in;
  for (int i = 0; i < 50000; ++i) {
    if (random() % 4 == 0) in.trip_pin = rare();
    in.tick_count = random();
    in.enabled = {random() % 4 == 0, random() % 4 == 0};
    in.clear = random() % 2 == 0;
    in.over_current = {rare(), rare()};
    in.watchdog = rare();
    in.encoder = {rare(), rare()};
    in.stroke = {rare(), rare()};
    apply(rtl, in);
    if (random() % 200 == 0) {
      rtl.reset();
      twin.reset();
    }
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    rtl.tick();
    const Supervisor::Out out = twin.step(in);
    REQUIRE(bool(rtl->trip_o) == out.trip);
    REQUIRE(rtl->fault_code_o == static_cast<int>(out.code));
    REQUIRE(bool(rtl->fault_axis_o) == out.axis);
    REQUIRE(rtl->fault_tick_o == out.tick);
  }
}

TEST_CASE("supervisor trips at the third edge after the pin, so that gates follow at the fourth") {
  Rtl rtl;
  rtl.reset();
  In in;
  in.tick_count = 77;
  in.trip_pin = true;
  step(rtl, in);
  REQUIRE_FALSE(rtl->trip_o);
  step(rtl, in);
  REQUIRE_FALSE(rtl->trip_o);
  step(rtl, in);
  REQUIRE(rtl->trip_o);
  REQUIRE(rtl->fault_code_o == 1);
  REQUIRE(rtl->fault_tick_o == 77);
}

TEST_CASE("gates are off four edges after the trip pin and stay off until the trip is cleared") {
  Rtl rtl;
  rtl.reset();
  trammel::exact::GateLeg leg;
  In in;
  in.enabled = {true, true};
  const auto edge = [&] {
    apply(rtl, in);
    const bool trip = rtl->trip_o;  // what the leg sees at this edge
    rtl.tick();
    return leg.step({true, trip, true, 100}).hi;
  };
  for (int i = 0; i < 200; ++i) edge();
  REQUIRE(leg.out().hi);
  in.trip_pin = true;
  for (int i = 0; i < 3; ++i) REQUIRE(edge());
  REQUIRE_FALSE(edge());
  in.trip_pin = false;  // the cause goes, the trip stays
  in.clear = true;
  for (int i = 0; i < 500; ++i) REQUIRE_FALSE(edge());
  in.enabled = {false, false};
  REQUIRE_FALSE(edge());
  REQUIRE_FALSE(rtl->trip_o);
}

TEST_CASE("supervisor reports code, axis and tick of each cause one edge later") {
  struct Row {
    In in;
    int code;
    int axis;
  };
  std::array<Row, 7> rows{};
  rows[0].in.over_current = {true, false};
  rows[0].code = 2;
  rows[1].in.over_current = {false, true};
  rows[1].code = 2;
  rows[1].axis = 1;
  rows[2].in.watchdog = true;
  rows[2].code = 3;
  rows[3].in.encoder = {false, true};
  rows[3].code = 4;
  rows[3].axis = 1;
  rows[4].in.encoder = {true, true};
  rows[4].code = 4;
  rows[5].in.stroke = {true, false};
  rows[5].code = 5;
  rows[6].in.stroke = {false, true};
  rows[6].code = 5;
  rows[6].axis = 1;
  Rtl rtl;
  std::uint32_t tick = 100;
  for (Row& row : rows) {
    rtl.reset();
    row.in.tick_count = ++tick;
    step(rtl, row.in);
    REQUIRE(rtl->trip_o);
    REQUIRE(rtl->fault_code_o == row.code);
    REQUIRE(rtl->fault_axis_o == row.axis);
    REQUIRE(rtl->fault_tick_o == tick);
  }
}

TEST_CASE("supervisor keeps the first fault") {
  Rtl rtl;
  rtl.reset();
  In in;
  in.tick_count = 5;
  in.stroke = {false, true};
  step(rtl, in);
  In later;
  later.tick_count = 6;
  later.over_current = {true, true};
  step(rtl, later);
  REQUIRE(rtl->fault_code_o == 5);
  REQUIRE(rtl->fault_axis_o == 1);
  REQUIRE(rtl->fault_tick_o == 5);
}

TEST_CASE("supervisor clears only on a clear with both axes disabled and the causes gone") {
  Rtl rtl;
  rtl.reset();
  In in;
  in.watchdog = true;
  in.enabled = {true, true};
  step(rtl, in);
  in.clear = true;
  step(rtl, in);
  REQUIRE(rtl->trip_o);  // enabled, cause present
  in.watchdog = false;
  step(rtl, in);
  REQUIRE(rtl->trip_o);  // enabled
  in.enabled = {false, true};
  step(rtl, in);
  REQUIRE(rtl->trip_o);  // Y enabled
  in.enabled = {false, false};
  in.stroke = {true, false};
  step(rtl, in);
  REQUIRE(rtl->trip_o);  // another cause
  in.stroke = {false, false};
  in.clear = false;
  step(rtl, in);
  REQUIRE(rtl->trip_o);  // no clear
  in.clear = true;
  step(rtl, in);
  REQUIRE_FALSE(rtl->trip_o);
  REQUIRE(rtl->fault_code_o == 0);
}
