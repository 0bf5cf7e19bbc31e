// SPDX-License-Identifier: Apache-2.0
//
// The 35 steps of the report page give what the bit-exact twin of the chip gives.
#include <catch2/catch.hpp>

#include <random>

#include "models/exact/control/afc.hpp"
#include "machines/kung/afc_steps.hpp"

using namespace trammel;
using kung::afc_steps;
using kung::AfcSteps;

namespace {

exact::Afc::Config twin_config(const sw::AxisSetup& s) {
  exact::Afc::Config c;
  c.kp = {s.kp.mant, s.kp.exp};
  c.ki = {s.ki.mant, s.ki.exp};
  c.kv = {s.kv.mant, s.kv.exp};
  c.eta = {s.eta.mant, s.eta.exp};
  c.shift_e = s.shift_e;
  c.shift_de = s.shift_de;
  c.a0 = static_cast<std::int32_t>(s.a0);
  c.a0_scale = static_cast<int>(s.a0_scale);
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
    const AfcSteps steps = afc_steps(setup, start);
    CAPTURE(k);
    REQUIRE(steps[4].result == expected.dx);
    REQUIRE(steps[5].result == expected.x_m);
    REQUIRE(steps[6].result == expected.x_r);
    REQUIRE(steps[7].result == expected.v);
    REQUIRE(steps[8].result == expected.e);
    REQUIRE(steps[9].result == expected.de);
    REQUIRE(steps[22].result == expected.u);
    REQUIRE(steps[25].result == twin.integral());
    REQUIRE(steps[26].result == expected.v_star);
    REQUIRE(steps[29].result == expected.i_q_ref);
    const auto fired = exact::RuleStore::fired(expected.i, expected.j);
    for (std::size_t n = 0; n < 4; ++n) {
      REQUIRE(steps[15 + n].result == expected.d[n]);
      REQUIRE(steps[31 + n].result == twin.rule(fired[n]));
      start.rules[static_cast<std::size_t>(fired[n])] = twin.rule(fired[n]);
    }
    start.r_2 = start.r_1;
    start.r_1 = start.r;
    start.x_p_prev = start.x_p;
    start.x_m = expected.x_m;
    start.dx = expected.dx;
    start.e_prev = expected.e;
    start.integral = twin.integral();
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
  setup.shift_e = -1;
  setup.shift_de = -2;
  check_chase(setup, 2000);
  for (const std::uint32_t scale : {1u, 2u, 3u}) {  // 3 acts as 2
    CAPTURE(scale);
    setup.a0_scale = scale;
    setup.a0 = scale == 1 ? 14876 : 465;
    check_chase(setup, 2000);
  }
}

TEST_CASE("the steps are those of the specification for its check vector") {
  // Section 5: e = 1000, de = 200 with a fresh table.
  kung::AfcStart start;
  const exact::Afc fresh;
  for (std::size_t n = 0; n < 49; ++n) start.rules[n] = fresh.rule(static_cast<int>(n));
  start.r = start.r_1 = start.r_2 = 1000;  // the model rests there
  start.x_m = 1000 << 14;
  start.e_prev = 800;
  const AfcSteps steps = afc_steps({}, start);
  CHECK(steps[8].result == 1000);
  CHECK(steps[9].result == 200);
  CHECK(steps[15].result == 42);
  CHECK(steps[16].result == 854);
  CHECK(steps[17].result == 54);
  CHECK(steps[18].result == 1098);
  CHECK(steps[22].result == 1526);
  CHECK(steps[26].result == 577);
  CHECK(steps[29].result == 1062);
}
