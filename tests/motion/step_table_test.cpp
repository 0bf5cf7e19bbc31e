// SPDX-License-Identifier: Apache-2.0
//
// Both axes beside their twin; what they mean is asked by the tests of the chip that has them.
#include <Vstep_table.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/motion/step_table.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"

using trammel::exact::Gap;
using trammel::exact::StepTable;
using trammel::test::Random;

namespace {

struct Bench {
  trammel::test::Rtl<Vstep_table> rtl;
  StepTable twin;
  StepTable::In in;

  Bench() {
    rtl->leap_i = 0;
    apply();
    rtl.reset();
    for (int i = 0; i < 4; ++i) tick();
    rtl.reset();
    twin.reset();
  }

  void apply() {
    const auto pair = [this](auto pin) {
      return static_cast<std::uint8_t>(pin(in.pins[0]) | pin(in.pins[1]) << 1);
    };
    rtl->limit_low_i = pair([](const auto& p) { return int{p.low}; });
    rtl->limit_high_i = pair([](const auto& p) { return int{p.high}; });
    rtl->buf_busy_i = pair([](const auto& p) { return int{p.buf_busy}; });
    rtl->write_i = in.write;
    rtl->y_i = in.y;
    rtl->bytes_i = in.bytes & 15;
    rtl->data_i = in.data;
    rtl->grant_i = in.grant;
    rtl.eval();
  }

  void tick() {
    apply();
    rtl.tick();
    twin.step(in);
  }

  void leap(Gap n) {
    rtl->leap_i = (n - 1) & 0xFFF;
    rtl.tick();
    rtl->leap_i = 0;
    twin.advance(n);
  }

  void write(bool y, unsigned bytes, std::uint32_t data) {
    in.write = true;
    in.y = y;
    in.bytes = bytes;
    in.data = data;
    tick();
    in.write = false;
  }

  void compare() {
    apply();
    const auto x = twin.axis(0), y = twin.axis(1);
    REQUIRE(rtl->step_o == (x.step | y.step << 1));
    REQUIRE(rtl->forward_o == (x.forward | y.forward << 1));
    REQUIRE(rtl->flush_o == (x.flush | y.flush << 1));
    REQUIRE(rtl->x_o == twin.words(0));
    REQUIRE(rtl->y_o == twin.words(1));
    REQUIRE(rtl->err_byte_o == twin.err_byte());
    REQUIRE(bool(rtl->irq_o) == twin.irq());
    REQUIRE(rtl->vector_o == twin.vector());
    REQUIRE(bool(rtl->quiescent_o) == twin.quiescent(in));
    REQUIRE(rtl->next_o == twin.next());
  }
};

}  // namespace

TEST_CASE("step_table agrees with its twin on random writes, switches, grants and leaps") {
  Bench bench;
  Random random(11);
  int both = 0;
  for (int i = 0; i < 150000; ++i) {
    bench.in.grant = random() % 500 == 0;
    bench.in.write = random() % 300 == 0;
    bench.in.y = random() % 2 == 0;
    bench.in.bytes = random() % 3 == 0 ? random() % 16 : 15;
    const std::uint32_t count = 0xFFFF - random() % 5;
    bench.in.data = (4095 - random() % 100) << 16 | (random() & 0xF) << 28 | count;
    if (random() % 8 == 0) bench.in.data = random();
    for (auto& pins : bench.in.pins) {
      if (random() % 2000 == 0) pins.low = random() % 4 == 0;
      if (random() % 2000 == 0) pins.high = random() % 4 == 0;
      if (random() % 500 == 0) pins.buf_busy = random() % 3 == 0;
    }
    bench.compare();
    const Gap gap = bench.twin.quiescent(bench.in) ? bench.twin.next() : 0;
    if (gap > 1 && random() % 2 == 0) {
      bench.leap(1 + random() % gap);
    } else {
      bench.tick();
    }
    both += bench.twin.axis(0).irq && bench.twin.axis(1).irq;
  }
  CHECK(both > 100);
  CHECK(bench.twin.err_byte() > 50);
}

TEST_CASE("step_table: the count of byte writes stays at 65535") {
  Bench bench;
  for (int i = 0; i < 65540; ++i) bench.write(false, 1, 0);
  bench.compare();
  CHECK(bench.rtl->err_byte_o == 65535);
}

TEST_CASE("step_table: an axis does not see what is written to the other") {
  Bench bench;
  bench.write(true, 15, 0x0F00FFF0);
  bench.compare();
  CHECK(bench.rtl->x_o == 0x0000FFFF);
  CHECK(bench.rtl->y_o == 0x0F00FFF0);
}
