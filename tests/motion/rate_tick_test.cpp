// SPDX-License-Identifier: Apache-2.0
#include <Vrate_tick.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/motion/rate_tick.hpp"
#include "tests/support/leaps.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::RateTick;
using trammel::test::Random;

namespace {

struct Rtl : trammel::test::Rtl<Vrate_tick> {
  Rtl() {
    (*this)->leap_i = 0;
    reset();
  }
};

}  // namespace

TEST_CASE("rate_tick agrees with its twin, leaping and not") {
  Rtl rtl;
  RateTick twin;
  Random random(4);
  int ticks = 0;
  for (int i = 0; i < 200'000; ++i) {
    if (random() % 20'000 == 0) {
      rtl.reset();
      twin.reset();
    }
    REQUIRE(bool(rtl->tick_o) == twin.tick());
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent());
    REQUIRE(rtl->next_o == twin.next());
    ticks += twin.tick();
    trammel::test::leap_or_step(rtl, twin, twin.next(), random, 3);
  }
  CHECK(ticks > 1000);
}

TEST_CASE("rate_tick gives 4612 ticks a second exactly, each within a clock of its time") {
  Rtl rtl;
  std::int64_t clock = 0, ticks = 0;
  while (clock < 50'000'000) {
    const Gap n = rtl->quiescent_o && rtl->next_o > 1 ? rtl->next_o : 1;
    if (rtl->tick_o) {
      ++ticks;
      const double exact = 1 + static_cast<double>(ticks) * 50e6 / 4612;  // [clk] from the load on
      REQUIRE(static_cast<double>(clock) + 1 > exact - 1);
      REQUIRE(static_cast<double>(clock) + 1 < exact + 1);
    }
    rtl->leap_i = (n - 1) & 0xFFF;
    rtl.tick();
    rtl->leap_i = 0;
    rtl.eval();
    clock += n;
  }
  CHECK(ticks == 4611);  // the last one of the second comes a clock behind its end
}
