// SPDX-License-Identifier: Apache-2.0

#include "models/exact/control/precision_knots.hpp"

#include <Vprecision_knots.h>

#include <catch2/catch.hpp>

#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::PrecisionKnots;
using trammel::test::Random;
using Knot = PrecisionKnots::Knot;

namespace {

struct Bench {
  trammel::test::Rtl<Vprecision_knots> rtl;
  PrecisionKnots twin;
  PrecisionKnots::In in;
  bool knot = false, underrun = false;  // of the last clock

  Bench() {
    apply();
    rtl.reset();
  }

  void apply() {
    rtl->tick_i = in.tick;
    rtl->tick_pos_i = in.tick_pos;
    rtl->commit_i = in.commit;
    rtl->off_i = in.off;
    rtl.eval();
  }

  void clock() {
    apply();
    knot = rtl->knot_o;
    underrun = rtl->underrun_o;
    rtl.tick();
    twin.clock(in);
    const bool is = in.tick && !in.off && twin.knot() != Knot::kNone;
    REQUIRE(knot == is);
    REQUIRE(underrun == (is && twin.underrun()));
    REQUIRE(bool(rtl->taken_o) == (twin.knot() == Knot::kCommit));
    REQUIRE(bool(rtl->coast_o) == (twin.knot() == Knot::kCoast));
    REQUIRE(bool(rtl->hold_o) == (twin.knot() == Knot::kHold));
  }

  bool tick(bool commit = false, bool pos = false) {
    in = {true, pos, commit, false};
    clock();
    in = {};
    return knot;
  }
};

}  // namespace

TEST_CASE("precision_knots agrees with its twin on random ticks, COMMITs, resets") {
  Bench bench;
  Random random(1);
  for (int n = 0; n < 100000; ++n) {
    const unsigned rare = n % 20000 < 10000 ? 30 : 150;
    bench.in = {random() % 2 == 0, random() % 8 == 0, random() % rare == 0, random() % 2000 == 0};
    bench.clock();
  }
}

TEST_CASE("The first knot is the 2 kHz tick after a COMMIT, every 32nd tick is the next") {
  Bench bench;
  for (int n = 0; n < 40; ++n) REQUIRE_FALSE(bench.tick(false, n % 8 == 0));
  REQUIRE_FALSE(bench.tick(true, true));  // a COMMIT in the clock of a tick is for the next one
  for (int n = 1; n < 8; ++n) REQUIRE_FALSE(bench.tick(false, false));
  for (int n = 0; n < 320; ++n) {
    REQUIRE(bench.tick(n % 32 == 5, n % 8 == 0) == (n % 32 == 0));
    REQUIRE_FALSE(bench.underrun);
  }
}

TEST_CASE("Knots without a COMMIT: twice at constant speed, then none, until the next COMMIT") {
  Bench bench;
  bench.tick(true);
  for (int k = 0; k < 8; ++k) {
    REQUIRE(bench.tick(false, true));
    CAPTURE(k);
    const bool taken = k == 0 || k == 5;
    REQUIRE(bench.underrun == !taken);
    REQUIRE(bool(bench.rtl->taken_o) == taken);
    REQUIRE(bool(bench.rtl->hold_o) == (k == 3 || k == 4));
    bench.apply();
    REQUIRE(bench.rtl->quiescent_o);
    for (int n = 1; n < 32; ++n) {
      bench.tick(k == 4 && n == 31);
      REQUIRE_FALSE(bench.rtl->taken_o);
    }
  }
}

TEST_CASE("In reset there is no knot and COMMITs are lost") {
  Bench bench;
  bench.tick(true);
  bench.in = {false, false, true, true};
  bench.clock();
  for (int n = 0; n < 40; ++n) REQUIRE_FALSE(bench.tick(false, true));
  bench.in = {true, true, true, true};
  bench.clock();
  bench.apply();
  REQUIRE(bench.rtl->quiescent_o);  // nothing wakes it there
}

TEST_CASE("precision_knots is quiescent only when the next edge changes nothing") {
  Bench bench;
  bench.clock();
  REQUIRE(bench.rtl->quiescent_o);
  bench.in.commit = true;
  bench.apply();
  REQUIRE_FALSE(bench.rtl->quiescent_o);
  bench.clock();
  REQUIRE(bench.rtl->quiescent_o);  // it waits already
  bench.in = {true, true, false, false};
  bench.apply();
  REQUIRE_FALSE(bench.rtl->quiescent_o);
}
