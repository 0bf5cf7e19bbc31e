// SPDX-License-Identifier: Apache-2.0

#include <Vtimer.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "models/exact/math/timer.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::kGapMax;
using trammel::exact::Timer;
using trammel::test::Random;

namespace {

// Does not leap unless told to.
struct Rtl : trammel::test::Rtl<Vtimer> {
  Rtl() { (*this)->leap_i = 0; }
};

void load(Rtl& rtl, std::uint32_t value) {
  rtl->load_i = 1;
  rtl->value_i = value & 0xFFF;
  rtl.tick();
  rtl->load_i = 0;
  rtl.eval();
}

void leap(Rtl& rtl, Gap n) {
  rtl->leap_i = n & 0xFFF;
  rtl.tick();
  rtl->leap_i = 0;
  rtl.eval();
}

}  // namespace

TEST_CASE("timer agrees with its twin on random loads and leaps") {
  Rtl rtl;
  Timer twin;
  rtl.reset();
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const Timer::In in{random() % 8 == 0, random() % (random() % 2 == 0 ? 4 : 4096)};
    rtl->load_i = in.load;
    rtl->value_i = in.value & 0xFFF;
    rtl.eval();
    if (random() % 200 == 0) {
      rtl.reset();
      twin.reset();
    }
    REQUIRE(rtl->next_o == twin.next(in));
    const Gap gap = twin.next(in);
    if (gap > 0 && random() % 2 == 0) {
      const Gap n = 1 + random() % std::min<Gap>(gap, 4095);
      leap(rtl, n - 1);
      twin.advance(n);
    } else {
      rtl.tick();
      twin.step(in);
    }
    REQUIRE(rtl->count_o == twin.count());
  }
}

TEST_CASE("timer loaded with n reaches zero at the nth edge and stays") {
  Rtl rtl;
  rtl.reset();
  for (const std::uint32_t n : {1U, 2U, 100U, 4095U}) {
    load(rtl, n);
    for (std::uint32_t i = 1; i < n; ++i) {
      rtl.tick();
      REQUIRE(rtl->count_o == n - i);
    }
    REQUIRE(rtl->next_o == 0);
    rtl.tick();
    REQUIRE(rtl->count_o == 0);
    REQUIRE(rtl->next_o == kGapMax);
    rtl.tick();
    REQUIRE(rtl->count_o == 0);
  }
}

TEST_CASE("timer announces a load as an event of the present edge") {
  Rtl rtl;
  rtl.reset();
  load(rtl, 50);
  REQUIRE(rtl->next_o == 49);
  rtl->load_i = 1;
  rtl.eval();
  REQUIRE(rtl->next_o == 0);
}

TEST_CASE("timer leap of n + 1 equals one step and then a leap of n for every count") {
  Rtl plain;
  Rtl leaping;
  plain.reset();
  leaping.reset();
  for (const Gap n : {0U, 1U, 2U, 7U, 100U, 4093U, 4094U}) {
    for (std::uint32_t count = 0; count < 4096; count += count < 130 ? 1 : 97) {
      load(plain, count);
      load(leaping, count);
      plain.tick();
      leap(plain, n);
      leap(leaping, n + 1);
      REQUIRE(plain->count_o == leaping->count_o);
    }
  }
}

TEST_CASE("timer gap falls by exactly one per clock and stays true over a leap") {
  Rtl rtl;
  rtl.reset();
  load(rtl, 3000);
  leap(rtl, 999);
  REQUIRE(rtl->count_o == 2000);
  REQUIRE(rtl->next_o == 1999);
  rtl.tick();
  REQUIRE(rtl->next_o == 1998);
}
