// SPDX-License-Identifier: Apache-2.0

#include <Vgate_leg.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "models/exact/drive/gate_leg.hpp"
#include "tests/support/leaps.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::GateLeg;
using In = GateLeg::In;
using trammel::test::leap_or_step;
using trammel::test::Random;

namespace {

// Does not leap unless told to.
struct Rtl : trammel::test::Rtl<Vgate_leg> {
  Rtl() { (*this)->leap_i = 0; }
};

void apply(Rtl& rtl, const In& in) {
  rtl->enable_i = in.enable;
  rtl->trip_i = in.trip;
  rtl->on_i = in.on;
  rtl->dead_time_i = in.dead_time & 0x3FF;
  rtl.eval();
}

void run(Rtl& rtl, const In& in, int clocks) {
  apply(rtl, in);
  for (int i = 0; i < clocks; ++i) rtl.tick();
}

// Edges under `in` until either gate is on.
int edges_to_on(Rtl& rtl, const In& in) {
  apply(rtl, in);
  int edges = 0;
  do {
    rtl.tick();
    ++edges;
  } while (!rtl->hi_o && !rtl->lo_o && edges < 5000);
  return edges;
}

In wish(bool on, std::uint32_t dead_time) { return {true, false, on, dead_time}; }

void change(In& in, Random& random) {
  if (random() % 20 == 0) in.on = !in.on;
  if (random() % 60 == 0) in.enable = !in.enable;
  if (random() % 60 == 0) in.trip = random() % 2 == 0;
  if (random() % 10 == 0) in.dead_time = random() % (random() % 4 == 0 ? 1024 : 12);
}

}  // namespace

TEST_CASE("gate_leg agrees with its twin on random inputs, leaps and resets") {
  Rtl rtl;
  GateLeg twin;
  rtl.reset();
  Random random(12);
  In in;
  for (int i = 0; i < 100000; ++i) {
    change(in, random);
    apply(rtl, in);
    if (random() % 500 == 0) {
      rtl.reset();
      twin.reset();
    }
    REQUIRE(rtl->next_o == twin.next(in));
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    const Gap gap = twin.quiescent(in) ? twin.next(in) : 0;
    rtl->clock_en_i = !twin.quiescent(in);  // its clock is gated where it rests
    leap_or_step(rtl, twin, gap, random, 4, in);
    rtl->clock_en_i = 1;
    REQUIRE(bool(rtl->hi_o) == twin.out().hi);
    REQUIRE(bool(rtl->lo_o) == twin.out().lo);
  }
}

TEST_CASE("gate_leg turns off at once and on exactly the dead time later, both sides") {
  for (const std::uint32_t dead : {1U, 2U, 3U, 50U, 100U, 1023U}) {
    Rtl rtl;
    rtl.reset();
    run(rtl, wish(false, dead), 1100);
    REQUIRE(rtl->lo_o);
    for (const bool on : {true, false, true, false}) {
      run(rtl, wish(on, dead), 1);
      REQUIRE_FALSE(rtl->hi_o);
      REQUIRE_FALSE(rtl->lo_o);
      REQUIRE(edges_to_on(rtl, wish(on, dead)) == static_cast<int>(dead));
      REQUIRE(bool(rtl->hi_o) == on);
      run(rtl, wish(on, dead), 20);
      REQUIRE(bool(rtl->hi_o) == on);
      REQUIRE(bool(rtl->lo_o) == !on);
    }
  }
}

TEST_CASE("gate_leg with dead time 0 still keeps both gates off for one clock") {
  Rtl rtl;
  rtl.reset();
  run(rtl, wish(false, 0), 10);
  REQUIRE(rtl->lo_o);
  run(rtl, wish(true, 0), 1);
  REQUIRE_FALSE(rtl->hi_o);
  REQUIRE_FALSE(rtl->lo_o);
  run(rtl, wish(true, 0), 1);
  REQUIRE(rtl->hi_o);
}

TEST_CASE("gate_leg counts a new dead time from the next change on") {
  Rtl rtl;
  rtl.reset();
  run(rtl, wish(false, 100), 200);
  run(rtl, wish(true, 100), 1);
  REQUIRE(edges_to_on(rtl, wish(true, 5)) == 100);
  run(rtl, wish(false, 5), 1);
  REQUIRE(edges_to_on(rtl, wish(false, 700)) == 5);
}

TEST_CASE("gate_leg restarts the dead time when the side changes inside it") {
  Rtl rtl;
  rtl.reset();
  run(rtl, wish(false, 100), 200);
  run(rtl, wish(true, 100), 60);
  run(rtl, wish(false, 100), 1);
  REQUIRE(edges_to_on(rtl, wish(false, 100)) == 100);
  REQUIRE(rtl->lo_o);
}

TEST_CASE("gate_leg is off at the edge after a trip or disable and returns a dead time later") {
  for (const bool trip : {false, true}) {
    Rtl rtl;
    rtl.reset();
    run(rtl, wish(true, 100), 200);
    REQUIRE(rtl->hi_o);
    In off = wish(true, 100);
    off.trip = trip;
    off.enable = trip;
    run(rtl, off, 1);
    REQUIRE_FALSE(rtl->hi_o);
    REQUIRE_FALSE(rtl->lo_o);
    run(rtl, off, 500);
    REQUIRE_FALSE(rtl->hi_o);
    REQUIRE_FALSE(rtl->lo_o);
    run(rtl, wish(true, 100), 1);
    REQUIRE(edges_to_on(rtl, wish(true, 100)) == 100);
    REQUIRE(rtl->hi_o);
  }
}

TEST_CASE("gate_leg never has both gates on, nor less than the shortest dead time between them") {
  const std::uint32_t shortest = GENERATE(0U, 4U);
  Rtl rtl;
  rtl.reset();
  Random random(13);
  In in;
  int last = -1;  // gate that was on last
  std::uint32_t off = 0;
  for (int i = 0; i < 150000; ++i) {
    change(in, random);
    in.dead_time = std::max(in.dead_time, shortest);
    run(rtl, in, 1);
    REQUIRE_FALSE((rtl->hi_o && rtl->lo_o));
    const int now = rtl->hi_o ? 1 : rtl->lo_o ? 0 : -1;
    if (now == -1) {
      ++off;
    } else {
      if (last != -1 && now != last) REQUIRE(off >= std::max(shortest, 1U));
      last = now;
      off = 0;
    }
  }
}

TEST_CASE("gate_leg that leaps has the same gates as one evaluated plainly") {
  Rtl plain;
  Rtl leaping;
  plain.reset();
  leaping.reset();
  Random random(14);
  for (int i = 0; i < 3000; ++i) {
    const In in{random() % 8 != 0, random() % 8 == 0, random() % 2 == 0, random() % 300};
    Gap left = 1 + random() % 600;
    apply(plain, in);
    apply(leaping, in);
    while (left > 0) {
      Gap n = leaping->quiescent_o ? leaping->next_o : 0;
      n = std::min(std::max<Gap>(n, 1), left);
      leaping->leap_i = (n - 1) & 0xFFF;
      leaping.tick();
      leaping->leap_i = 0;
      leaping.eval();
      for (Gap k = 0; k < n; ++k) {
        plain.tick();
        REQUIRE(plain->hi_o == leaping->hi_o);
        REQUIRE(plain->lo_o == leaping->lo_o);
      }
      left -= n;
    }
  }
}
