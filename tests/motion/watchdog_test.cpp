// SPDX-License-Identifier: Apache-2.0

#include <Vwatchdog.h>

#include <catch2/catch.hpp>
#include <vector>

#include "models/exact/motion/watchdog.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Watchdog;
using trammel::test::Random;
using Rtl = trammel::test::Rtl<Vwatchdog>;

namespace {

void apply(Rtl& rtl, const Watchdog::In& in) {
  rtl->tick_pos_i = in.tick_pos;
  rtl->kick_i = in.kick;
  rtl->enable_i = in.enable;
  rtl->limit_i = in.limit;
  rtl.eval();
}

// One position tick and an idle clock after it.
bool after_tick(Rtl& rtl, std::uint16_t limit, bool kick = false) {
  apply(rtl, {true, kick, true, limit});
  rtl.tick();
  apply(rtl, {false, false, true, limit});
  rtl.tick();
  return rtl->bite_o;
}

void kick(Rtl& rtl, std::uint16_t limit) {
  apply(rtl, {false, true, true, limit});
  rtl.tick();
}

}  // namespace

TEST_CASE("watchdog agrees with its twin on random inputs") {
  Rtl rtl;
  Watchdog twin;
  rtl.reset();
  Random random(3);
  for (int i = 0; i < 50000; ++i) {
    const Watchdog::In in{random() % 2 == 0, random() % 6 == 0, random() % 32 != 0,
                          static_cast<std::uint16_t>(random() % 7)};
    apply(rtl, in);
    if (random() % 200 == 0) {
      rtl.reset();
      twin.reset();
    }
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    rtl.tick();
    REQUIRE(bool(rtl->bite_o) == twin.step(in));
  }
}

TEST_CASE("watchdog counts the ticks of every bit of its limit, as its twin does") {
  Rtl rtl;
  Watchdog twin;
  Random random(4);
  std::vector<std::uint32_t> limits{0x5555, 0xAAAA, 0xFFFF};
  for (int bit = 0; bit < 16; ++bit) limits.push_back(1U << bit);
  for (const std::uint32_t limit : limits) {
    rtl.reset();
    twin.reset();
    std::uint32_t ticks = 0;
    while (!rtl->bite_o) {
      const Watchdog::In in{random() % 8 != 0, false, true, static_cast<std::uint16_t>(limit)};
      apply(rtl, in);
      REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
      rtl.tick();
      ticks += in.tick_pos;
      REQUIRE(bool(rtl->bite_o) == twin.step(in));
    }
    REQUIRE(ticks == limit + 1);
    for (int i = 0; i < 4; ++i) {
      const Watchdog::In in{true, true, true, static_cast<std::uint16_t>(limit)};
      apply(rtl, in);
      REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));  // a kick forgets the count
      rtl.tick();
      REQUIRE(twin.step(in));
    }
  }
}

TEST_CASE("watchdog limit lowered below the count bites at the next tick, a kick forgets it all") {
  Rtl rtl;
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    rtl.reset();
    for (std::uint32_t n = random() % 300; n > 0; --n) after_tick(rtl, 0xFFFF);
    if (random() % 4 == 0) {
      kick(rtl, 1);
      REQUIRE_FALSE(after_tick(rtl, 1));
      REQUIRE(after_tick(rtl, 1));
    } else {
      after_tick(rtl, 0xFFFF);
      REQUIRE(after_tick(rtl, 1));
    }
  }
}

TEST_CASE("watchdog allows limit ticks between two kicks and bites at the next") {
  Rtl rtl;
  for (const std::uint16_t limit : {std::uint16_t{1}, std::uint16_t{4}, std::uint16_t{20}}) {
    rtl.reset();
    for (int round = 0; round < 3; ++round) {
      kick(rtl, limit);
      for (int i = 0; i < limit; ++i) REQUIRE_FALSE(after_tick(rtl, limit));
    }
    REQUIRE(after_tick(rtl, limit));
  }
}

TEST_CASE("watchdog keeps its bite through kicks until it is disabled") {
  Rtl rtl;
  rtl.reset();
  after_tick(rtl, 1);
  REQUIRE(after_tick(rtl, 1));
  kick(rtl, 1);
  REQUIRE(after_tick(rtl, 1));
  REQUIRE(after_tick(rtl, 0));
  apply(rtl, {false, false, false, 1});
  REQUIRE_FALSE(rtl->quiescent_o);
  rtl.tick();
  REQUIRE_FALSE(rtl->bite_o);
}

TEST_CASE("watchdog with limit zero is off") {
  Rtl rtl;
  rtl.reset();
  for (int i = 0; i < 1000; ++i) REQUIRE_FALSE(after_tick(rtl, 0));
}

TEST_CASE("watchdog kick at the clock of a tick wins") {
  Rtl rtl;
  rtl.reset();
  for (int i = 0; i < 10; ++i) {
    REQUIRE_FALSE(after_tick(rtl, 1));
    REQUIRE_FALSE(after_tick(rtl, 1, true));
  }
}
