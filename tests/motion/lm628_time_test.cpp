// SPDX-License-Identifier: Apache-2.0

#include "models/exact/motion/lm628_time.hpp"

#include <Vlm628_time.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>

#include "tests/support/leaps.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::Lm628Clock;
using trammel::exact::Lm628Time;
using trammel::test::leap_or_step;
using trammel::test::Random;

namespace {

struct Rtl : trammel::test::Rtl<Vlm628_time> {
  Rtl() { (*this)->leap_i = 0; }
};

}  // namespace

TEST_CASE("lm628_time agrees with its twin, leaping and not, through resets") {
  Rtl rtl;
  Lm628Time twin;
  rtl.reset();
  Random random(51);
  for (int i = 0; i < 60000; ++i) {
    if (random() % 20000 == 0) {
      rtl.reset();
      twin.reset();
    }
    REQUIRE(rtl->next_o == twin.next());
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent());
    REQUIRE(bool(rtl->begin_o) == twin.begins());
    REQUIRE(bool(rtl->ready_o) == twin.ready());
    REQUIRE(bool(rtl->open_o) == twin.open());
    REQUIRE(bool(rtl->sample_o) == twin.sample());
    REQUIRE(bool(rtl->commit_o) == twin.commit());
    rtl->clock_en_i = !twin.quiescent();  // its clock is gated where it rests
    leap_or_step(rtl, twin, twin.next(), random, 2);
    rtl->clock_en_i = 1;
  }
}

// 8 MHz: 8000 ticks are 50 000 clocks, 2048 are 12 800, 400 are 2500.
TEST_CASE("lm628_time is ready after 50 000 clocks and then has samples of 12 800") {
  Rtl rtl;
  rtl.reset();
  int clock = 0;
  for (; !rtl->ready_o; ++clock) rtl.tick();
  REQUIRE(clock == 50000);
  for (clock = 0; clock < 3 * 12800; ++clock) {
    const int phase = clock % 12800;
    REQUIRE(bool(rtl->sample_o) == (phase == 10));
    REQUIRE(bool(rtl->commit_o) == (phase == 2499));
    REQUIRE(bool(rtl->open_o) == (phase >= 2371 && phase <= 12670));
    rtl.tick();
  }
}

TEST_CASE("lm628_time's twin at 6 MHz has samples of 17 066 2/3 clocks, none before its tick") {
  Lm628Time twin(Lm628Clock::k6MHz);
  std::int64_t clock = 0;
  for (; !twin.ready(); ++clock) twin.step();
  REQUIRE(clock == 66667);
  std::int64_t sample = 0;
  for (clock = 0; sample < 3000; ++clock) {
    if (twin.sample()) {
      // 25 n / 3 clocks are n ticks from the reset on, rounded up; ready is 8000 ticks behind it.
      REQUIRE(clock - 12 + 66667 == (25 * (8000 + 2048 * sample) + 2) / 3);
      ++sample;
    }
    const auto gap = static_cast<std::int64_t>(twin.next());
    twin.advance(static_cast<Gap>(gap));
    clock += gap;
    twin.step();
  }
}
