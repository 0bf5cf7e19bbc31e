// SPDX-License-Identifier: Apache-2.0
//
// The 35 steps of the report page give what the bit-exact twin of the chip gives.
#include <catch2/catch.hpp>

#include <random>

#include "models/exact/control/afc.hpp"
#include "machines/kung/afc_steps.hpp"

using namespace trammel;
using kung::AfcTrace;
using kung::trace_afc;

namespace {

exact::Afc::Config twin_config(const sw::AxisSetup& s) {
  exact::Afc::Config c;
  c.kp = {s.kp.mant, s.kp.exp};
  c.ki = {s.ki.mant, s.ki.exp};
  c.kv = {s.kv.mant, s.kv.exp};
  c.eta = {s.eta.mant, s.eta.exp};
  c.shift_e = static_cast<int>(s.shift_e);
  c.shift_de = static_cast<int>(s.shift_de);
  c.a0 = static_cast<std::int32_t>(s.a0);
  c.b2 = static_cast<std::int32_t>(fixed::wrap(s.b2, 24));
  c.adapt = s.adapt;
  c.feedforward = s.feedforward;
  return c;
}

// The table follows a command that jumps about, so that every section and both limits are reached.
void check_chase(const sw::AxisSetup& setup, int reach) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> jump(-reach, reach);
  exact::Afc twin;
  twin.reset(0);
  kung::AfcStart start;
  for (std::size_t n = 0; n < 49; ++n) start.rules[n] = twin.rule(static_cast<int>(n));
  for (int k = 0; k < 3000; ++k) {
    start.r = k % 50 == 0 ? start.r_1 + jump(random) : start.r_1;
    start.x_p = start.x_p_prev + jump(random) / 100;
    const exact::Afc::Out expected = twin.step(twin_config(setup), {start.r, start.x_p});
    const AfcTrace trace = trace_afc(setup, start);
    CAPTURE(k);
    REQUIRE(trace.end.x_m == expected.x_m);
    REQUIRE(trace.end.x_r == expected.x_r);
    REQUIRE(trace.end.dx == expected.dx);
    REQUIRE(trace.end.e == expected.e);
    REQUIRE(trace.end.de == expected.de);
    REQUIRE(trace.end.v == expected.v);
    REQUIRE(trace.end.u == expected.u);
    REQUIRE(trace.end.v_star == expected.v_star);
    REQUIRE(trace.end.i_q_ref == expected.i_q_ref);
    REQUIRE(trace.section_e == expected.i);
    REQUIRE(trace.section_de == expected.j);
    for (std::size_t n = 0; n < 4; ++n) {
      REQUIRE(*trace.steps[31 + n].result == twin.rule(trace.fired[n]));
      start.rules[static_cast<std::size_t>(trace.fired[n])] = twin.rule(trace.fired[n]);
    }
    start.r_2 = start.r_1;
    start.r_1 = start.r;
    start.x_p_prev = start.x_p;
    start.x_m = trace.end.x_m;
    start.dx = trace.end.dx;
    start.e_prev = trace.end.e;
    start.integral = trace.integral;
  }
}

}  // namespace

TEST_CASE("the steps of a sample end at the words and rules of the twin") {
  sw::AxisSetup setup;
  check_chase(setup, 2000);
  setup.adapt = true;
  check_chase(setup, 2000);
  check_chase(setup, 60);
  setup.feedforward = true;
  setup.shift_e = 2;
  setup.ki = {1500, -3};
  check_chase(setup, 2000);
}

TEST_CASE("the steps are those of the specification for its check vector") {
  // Section 5: e = 1000, de = 200 with a fresh table.
  kung::AfcStart start;
  const exact::Afc fresh;
  for (std::size_t n = 0; n < 49; ++n) start.rules[n] = fresh.rule(static_cast<int>(n));
  start.r = start.r_1 = start.r_2 = 1000;  // the model rests there
  start.x_m = 1000 << 14;
  start.e_prev = 800;
  const AfcTrace trace = trace_afc({}, start);
  CHECK(*trace.steps[8].result == 1000);
  CHECK(*trace.steps[9].result == 200);
  CHECK(*trace.steps[15].result == 42);
  CHECK(*trace.steps[16].result == 854);
  CHECK(*trace.steps[17].result == 54);
  CHECK(*trace.steps[18].result == 1098);
  CHECK(*trace.steps[22].result == 1526);
  CHECK(*trace.steps[26].result == 577);
  CHECK(*trace.steps[29].result == 1062);
  CHECK(trace.fired == std::array<int, 4>{32, 33, 39, 40});
}
