// SPDX-License-Identifier: Apache-2.0

#include "models/exact/sense/edge_time.hpp"

#include <Vedge_time.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::EdgeTime;
using trammel::test::Random;

namespace {

struct Bench {
  trammel::test::Rtl<Vedge_time> rtl;
  EdgeTime twin;
  EdgeTime::In in;
  std::int64_t clock = 0;  // since the first tick

  Bench() {
    apply();
    rtl.reset();
    twin.reset();
  }

  void apply() {
    rtl->tick_i = in.tick;
    rtl->phase_i = static_cast<std::uint16_t>(in.phase);
    rtl->filter_i = static_cast<std::uint8_t>(in.filter);
    rtl->edge_i = in.edge;
    rtl->up_i = in.up;
    rtl.eval();
  }

  void step() {
    apply();
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    rtl.tick();
    twin.clock(in);
    REQUIRE(rtl->ticks_o == twin.out().ticks);
    REQUIRE(rtl->age_o == static_cast<std::uint16_t>(twin.out().age));
    REQUIRE(bool(rtl->up_o) == twin.out().up);
  }

  // The clock of true ticks and phases, with or without an edge.
  void run(bool edge, bool up = false) {
    in.phase = static_cast<std::int32_t>(clock % EdgeTime::kPeriod);
    in.tick = in.phase == 0;
    in.edge = edge;
    in.up = up;
    step();
    ++clock;
  }
};

}  // namespace

TEST_CASE("edge_time agrees with its twin on random edges, ticks, phases, filters and resets") {
  Bench bench;
  Random random(1);
  for (int n = 0; n < 200000; ++n) {
    const unsigned calm = n % 40000 < 20000 ? 4 : 40;
    bench.in.tick = random() % 8 == 0;
    bench.in.phase = static_cast<std::int32_t>(random() % 8192);  // of any carrier
    bench.in.edge = random() % calm == 0;
    bench.in.up = random() % 2 == 0;
    if (random() % 50 == 0) bench.in.filter = static_cast<int>(random() % 16);
    if (random() % 3000 == 0) {
      bench.rtl.reset();
      bench.twin.reset();
    }
    bench.step();
  }
}

TEST_CASE("edge_time gives the clocks from the edge at the pin, up to 15 ticks later") {
  for (const int at : {0, 1, 2, 1500, 3123, 3124}) {
    for (const int filter : {0, 3, 15}) {
      CAPTURE(at, filter);
      Bench bench;
      bench.in.filter = filter;
      for (int n = 0; n < EdgeTime::kPeriod; ++n) bench.run(false);
      REQUIRE(bench.rtl->ticks_o == 15);
      for (int n = 0; n < EdgeTime::kPeriod; ++n) bench.run(n == at, true);
      // The count that an edge in the clock of a tick makes is seen by the next tick.
      for (int tick = 0; tick < 18; ++tick) {
        bench.run(false);
        CAPTURE(tick);
        // The pin changed 2 + filter clocks before the edge that counts it.
        const int passed = std::min(tick, 15) * EdgeTime::kPeriod + EdgeTime::kPeriod - at;
        REQUIRE(bench.rtl->ticks_o == std::min(tick, 15));
        REQUIRE(bench.rtl->age_o == passed + 2 + std::max(filter, 1));
        REQUIRE(bench.rtl->up_o);
        for (int n = 1; n < EdgeTime::kPeriod; ++n) bench.run(false);
      }
    }
  }
}

TEST_CASE("edge_time keeps the last of several edges and its way") {
  Bench bench;
  bench.run(false);
  for (int n = 1; n < EdgeTime::kPeriod; ++n) bench.run(n == 100 || n == 3000, n == 100);
  bench.run(false);
  REQUIRE(bench.rtl->age_o == 125 + 5);
  REQUIRE_FALSE(bench.rtl->up_o);
}
