// SPDX-License-Identifier: Apache-2.0
#include <Vstep_clock.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/motion/step_clock.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::StepClock;
using trammel::test::Random;

namespace {

struct Rtl : trammel::test::Rtl<Vstep_clock> {
  Rtl() {
    (*this)->leap_i = 0;
    reset();
  }
};

}  // namespace

TEST_CASE("step_clock agrees with its twin, leaping and not") {
  Rtl rtl;
  StepClock twin;
  Random random(4);
  for (int i = 0; i < 40000; ++i) {
    if (random() % 1000 == 0) {
      rtl.reset();
      twin.reset();
    }
    const Gap n = random() % 4 == 0 ? 1 + random() % 4096 : 1;
    rtl->leap_i = (n - 1) & 0xFFF;
    rtl.eval();
    const StepClock::Out out = twin.out();
    REQUIRE(bool(rtl->tick_o) == out.tick);
    REQUIRE(bool(rtl->half_o) == out.half);
    REQUIRE(rtl->next_tick_o == out.next_tick);
    REQUIRE(rtl->next_half_o == out.next_half);
    REQUIRE(rtl->ticks_o == twin.ticks(n));
    REQUIRE(rtl->quiescent_o);
    rtl.tick();
    twin.advance(n);
  }
}

TEST_CASE("step_clock gives 240 kHz exactly: 2400 ticks in 10 ms, each within a clock") {
  Rtl rtl;
  std::int64_t ticks = 0;
  for (std::int64_t clock = 1; clock <= 500000; ++clock) {
    rtl.eval();
    if (rtl->tick_o) {
      ++ticks;
      const double exact = static_cast<double>(ticks) * 50e6 / 240e3;  // [clk]
      REQUIRE(static_cast<double>(clock) >= exact);
      REQUIRE(static_cast<double>(clock) < exact + 1);
    }
    rtl.tick();
  }
  CHECK(ticks == 2400);
}

TEST_CASE("step_clock: half_o comes 104 clocks behind a tick") {
  Rtl rtl;
  int since = 0, seen = 0;
  for (int clock = 0; clock < 20000; ++clock) {
    rtl.eval();
    if (rtl->half_o && since != 0) {
      REQUIRE(clock - since == Approx(104).margin(1));  // of 208 or 209
      ++seen;
    }
    if (rtl->tick_o) since = clock;
    rtl.tick();
  }
  CHECK(seen > 90);
}
