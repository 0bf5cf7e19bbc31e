// SPDX-License-Identifier: Apache-2.0

#include <Vtimebase.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "models/exact/motion/timebase.hpp"
#include "tests/support/leaps.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::Timebase;
using trammel::test::leap_or_step;
using trammel::test::Random;

namespace {

// Does not leap unless told to.
struct Rtl : trammel::test::Rtl<Vtimebase> {
  Rtl() {
    (*this)->leap_i = 0;
    apply({});
  }

  void apply(const Timebase::In& in) {
    (*this)->irq_period_i = in.irq_period;
    (*this)->carrier_i = in.carrier & 3;
    (*this)->rate_i = in.rate & 3;
  }
};

void require_equal(Rtl& rtl, const Timebase& twin) {
  const Timebase::Out out = twin.out();
  REQUIRE(rtl->carrier_o == out.carrier);
  REQUIRE(rtl->phase_o == out.phase);
  REQUIRE(rtl->rest_o == trammel::exact::pwm_period(out.carrier) - out.phase);
  REQUIRE(bool(rtl->tick_cur_o) == out.tick_cur);
  REQUIRE(bool(rtl->tick_pos_o) == out.tick_pos);
  REQUIRE(bool(rtl->tick_irq_o) == out.tick_irq);
  REQUIRE(rtl->tick_count_o == out.tick_count);
  REQUIRE(bool(rtl->quiescent_o) == out.quiescent);
  REQUIRE(rtl->next_o == twin.next());
}

}  // namespace

TEST_CASE("timebase agrees with its twin on random leaps, rates and interrupt periods") {
  Rtl rtl;
  Timebase twin;
  rtl.reset();
  Random random(2);
  Timebase::In in;
  for (int i = 0; i < 60000; ++i) {
    in.irq_period = static_cast<std::uint8_t>(random() % 6);
    if (random() % 500 == 0) in.carrier = random() % 4;
    if (random() % 500 == 0) in.rate = random() % 4;
    rtl.apply(in);
    rtl.eval();
    if (random() % 300 == 0) {
      rtl.reset();
      twin.reset();
    }
    require_equal(rtl, twin);
    leap_or_step(rtl, twin, twin.next(), random, 1, in);
  }
}

TEST_CASE("timebase ticks are exactly 3125, 25000 and 100000 clocks apart") {
  Rtl rtl;
  rtl.reset();
  rtl->irq_period_i = 4;
  std::vector<int> cur;
  std::vector<int> pos;
  std::vector<int> irq;
  for (int n = 0; n < 300001; ++n) {
    rtl.eval();
    REQUIRE(rtl->phase_o == n % 3125);
    if (rtl->tick_cur_o) cur.push_back(n);
    if (rtl->tick_pos_o) pos.push_back(n);
    if (rtl->tick_irq_o) irq.push_back(n);
    if (rtl->tick_pos_o) REQUIRE(rtl->tick_cur_o);
    if (rtl->tick_irq_o) REQUIRE(rtl->tick_pos_o);
    rtl.tick();
  }
  REQUIRE(cur.size() == 97);
  REQUIRE(pos.size() == 13);
  REQUIRE(irq.size() == 4);
  for (std::size_t i = 0; i < cur.size(); ++i) REQUIRE(cur[i] == static_cast<int>(i) * 3125);
  for (std::size_t i = 0; i < pos.size(); ++i) REQUIRE(pos[i] == static_cast<int>(i) * 25000);
  for (std::size_t i = 0; i < irq.size(); ++i) REQUIRE(irq[i] == static_cast<int>(i) * 100000);
  REQUIRE(rtl->tick_count_o == 13);
}

TEST_CASE("timebase has 8, 16, 20 and 40 kHz and position ticks of 1, 2 and 4 kHz") {
  constexpr int kFrequencies[] = {16000, 8000, 20000, 40000}, kPositions[] = {1000, 2000, 4000};
  for (unsigned carrier = 0; carrier < 4; ++carrier) {
    for (unsigned rate = 0; rate < 3; ++rate) {
      Rtl rtl;
      rtl.apply({4, carrier, rate});
      rtl.reset();
      const int period = 50'000'000 / kFrequencies[carrier];
      const int position = 50'000'000 / kPositions[rate];
      CAPTURE(period, position);
      for (int n = 0; n < 3 * position; ++n) {
        rtl.eval();
        REQUIRE(bool(rtl->tick_cur_o) == (n % period == 0));
        REQUIRE(bool(rtl->tick_pos_o) == (n % position == 0));
        REQUIRE(rtl->phase_o == n % period);
        if (n > 0) REQUIRE(rtl->carrier_o == carrier);
        rtl.tick();
      }
    }
  }
}

TEST_CASE("timebase of a clock of 48 MHz ticks at the same frequencies") {
  constexpr int kFrequencies[] = {16000, 8000, 20000, 40000};
  for (unsigned carrier = 0; carrier < 4; ++carrier) {
    Timebase twin(48'000'000);
    for (const bool again : {false, true}) {
      CAPTURE(carrier, again);
      for (int n = 0; n < 50'000; ++n) {
        const Timebase::Out out = twin.out();
        REQUIRE(out.tick_cur == (n % (48'000'000 / kFrequencies[carrier]) == 0));
        REQUIRE(out.tick_pos == (n % 24'000 == 0));
        twin.step({4, carrier, 1});
      }
      twin.reset();
    }
  }
}

TEST_CASE("timebase interrupt period 0 acts as 1") {
  Rtl rtl;
  rtl.reset();
  rtl->irq_period_i = 0;
  int ticks = 0;
  for (int n = 0; n < 75000; ++n) {
    rtl.eval();
    REQUIRE(rtl->tick_irq_o == rtl->tick_pos_o);
    ticks += rtl->tick_irq_o;
    rtl.tick();
  }
  REQUIRE(ticks == 3);
}

TEST_CASE("timebase agrees with its twin over 8192 ticks and interrupt periods up to 255") {
  Rtl rtl;
  Timebase twin;
  rtl.reset();
  Random random(3);
  Timebase::In in{255};
  while (twin.out().tick_count < 8192) {
    rtl->irq_period_i = in.irq_period;
    rtl.eval();
    require_equal(rtl, twin);
    const Gap gap = twin.next();
    rtl->leap_i = gap > 0 ? (gap - 1) & 0xFFF : 0;
    if (gap > 0) {
      twin.advance(gap);
    } else {
      const std::uint32_t any = random() % 2 == 0 ? random() : 1U << random() % 8;
      if (twin.out().tick_irq) in.irq_period = static_cast<std::uint8_t>(any);
      rtl->irq_period_i = in.irq_period;
      twin.step(in);
    }
    rtl.tick();
    rtl->leap_i = 0;
    rtl.eval();
  }
}

TEST_CASE("timebase needs at most three evaluations a period when it leaps") {
  Rtl rtl;
  rtl.reset();
  rtl->irq_period_i = 4;
  std::int64_t clocks = 0;
  int evaluations = 0;
  int ticks = 0;
  while (clocks < 1000000) {
    rtl->leap_i = 0;
    rtl.eval();
    if (rtl->tick_cur_o) {
      REQUIRE(clocks % 3125 == 0);
      ++ticks;
    }
    const Gap gap = rtl->next_o;
    rtl->leap_i = gap > 0 ? (gap - 1) & 0xFFF : 0;
    rtl.tick();
    clocks += gap > 0 ? gap : 1;
    ++evaluations;
  }
  REQUIRE(ticks == 320);
  // One leap, the last count and the tick.
  REQUIRE(evaluations <= 3 * 320);
}
