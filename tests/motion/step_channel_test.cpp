// SPDX-License-Identifier: Apache-2.0
//
// One axis beside its twin, at random; what it means is asked of the whole chip, by the tests
// of the chip that has it.
#include <Vstep_channel.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/motion/step_channel.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::StepChannel;
using trammel::exact::StepClock;
using trammel::test::Random;
namespace exact = trammel::exact;

namespace {

// The channel with the clock of its twin: it is that of step_clock, which has its own test.
struct Bench {
  trammel::test::Rtl<Vstep_channel> rtl;
  StepChannel twin;
  StepClock clock;
  StepChannel::In in;

  Bench() {
    apply(1);
    rtl.reset();
    for (int i = 0; i < 4; ++i) tick();
    rtl.reset();
    twin.reset();
  }

  void apply(Gap n) {
    const StepClock::Out now = clock.out();
    rtl->tick_i = now.tick;
    rtl->half_i = now.half;
    rtl->next_tick_i = now.next_tick & 0xFFF;
    rtl->next_half_i = now.next_half & 0xFFF;
    rtl->ticks_i = clock.ticks(n) & 0xFFF;
    rtl->limit_low_i = in.pins.low;
    rtl->limit_high_i = in.pins.high;
    rtl->buf_busy_i = in.pins.buf_busy;
    rtl->count_write_i = in.count.has_value();
    rtl->count_i = in.count.value_or(0x1234);
    rtl->status_write_i = in.status.has_value();
    rtl->status_i = in.status.value_or(0xFFFF);
    rtl->grant_i = in.grant;
    rtl.eval();
  }

  void tick() {
    apply(1);
    rtl.tick();
    twin.step(in, clock.out());
    clock.step();
  }

  void leap(Gap n) {
    apply(n);
    rtl.tick();
    twin.advance(clock.ticks(n));
    clock.advance(n);
  }

  void compare() {
    apply(1);
    const StepChannel::Out out = twin.out();
    REQUIRE(bool(rtl->step_o) == out.step);
    REQUIRE(bool(rtl->forward_o) == out.forward);
    REQUIRE(bool(rtl->flush_o) == out.flush);
    REQUIRE(bool(rtl->irq_o) == out.irq);
    REQUIRE(rtl->count_o == out.count);
    REQUIRE(rtl->status_o == out.status);
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    REQUIRE(rtl->next_o == twin.next(clock));
  }
};

// Rates that are reached within a test, and few steps.
std::uint16_t status(Random& random) {
  const std::uint32_t rate = random() % 2 == 0 ? 4095 - random() % 8 : 4095 - random() % 200;
  const std::uint32_t any = random() & 0xFFF;
  return static_cast<std::uint16_t>((random() % 8 == 0 ? any : rate) | (random() & 0xF) << 12);
}
std::uint16_t count(Random& random) {
  return static_cast<std::uint16_t>(random() % 8 == 0 ? random() : 0xFFFF - random() % 6);
}

}  // namespace

TEST_CASE("step_channel agrees with its twin on random words, switches, grants and leaps") {
  Bench bench;
  Random random(7);
  int steps = 0, trips = 0, ends = 0;
  bool was_step = false, was_flush = false, was_busy = false;
  for (int i = 0; i < 200000; ++i) {
    bench.in.count.reset();
    bench.in.status.reset();
    bench.in.grant = random() % 400 == 0;
    if (random() % 300 == 0) bench.in.count = count(random);
    if (random() % 300 == 0) bench.in.status = status(random);
    if (random() % 700 == 0) bench.in.pins.low = random() % 3 == 0;
    if (random() % 700 == 0) bench.in.pins.high = random() % 3 == 0;
    if (random() % 200 == 0) bench.in.pins.buf_busy = random() % 2 == 0;
    if (random() % 5000 == 0) {
      bench.rtl.reset();
      bench.twin.reset();
    }
    bench.compare();
    const Gap gap = bench.twin.quiescent(bench.in) ? bench.twin.next(bench.clock) : 0;
    if (gap > 1 && random() % 2 == 0) {
      bench.leap(1 + random() % gap);
    } else {
      bench.tick();
    }
    const StepChannel::Out out = bench.twin.out();
    const bool busy = (out.status & exact::kStepBusy) != 0;
    steps += out.step && !was_step;
    trips += out.flush && !was_flush;
    ends += was_busy && !busy && !out.flush;
    was_step = out.step;
    was_flush = out.flush;
    was_busy = busy;
  }
  CHECK(steps > 300);
  CHECK(trips > 30);
  CHECK(ends > 60);
}
