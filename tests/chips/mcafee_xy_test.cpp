// SPDX-License-Identifier: Apache-2.0
//
// The chip beside its twin, pin by pin, over random traffic of both axes; the port's times on the
// pins; the parts at 6 MHz.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>

#include "tests/chips/mcafee_bench.hpp"
#include "tests/chips/mcafee_transfers.hpp"
#include "tests/support/checked.hpp"
#include "tests/support/random.hpp"

using trammel::exact::FeedRate;
using trammel::exact::Lm628Bridge;
using trammel::sw::Lm628Command;
using trammel::sw::Lm628Port;
using trammel::test::McafeePair;
using trammel::test::McafeeTwin;
using trammel::test::ordered;
using trammel::test::own_traffic;
using trammel::test::Random;
using trammel::test::run_random;
using trammel::test::traffic;
using trammel::test::trials;
using trammel::test::wild;
namespace reg = trammel::mcafee_xy_regs;
using Bench = trammel::test::McafeeBench<McafeePair>;
using TwinBench = trammel::test::McafeeBench<McafeeTwin>;

namespace {

// Times at the parts' pins [clk of 20 ns], as an oscilloscope would find them.
struct Scope {
  int writes = 0, reads = 0;
  std::int64_t fell = 0, rose = -1000, moved = -1000;
  bool low = false, wrote = false;
  Lm628Bridge::Out was;

  void look(std::int64_t now, const Lm628Bridge::Out& pins) {
    const bool strobe = !pins.rd_n || !pins.wr_n;
    const bool same = pins.d == was.d && pins.ps == was.ps && pins.cs_x_n == was.cs_x_n &&
                      pins.cs_y_n == was.cs_y_n && pins.transceiver == was.transceiver;
    REQUIRE((pins.cs_x_n || pins.cs_y_n));
    REQUIRE((pins.rd_n || pins.wr_n));
    REQUIRE_FALSE((pins.transceiver && pins.selector));
    if (!same) {
      REQUIRE_FALSE((low || strobe));
      REQUIRE((now - rose) * 20 >= (wrote ? 120 : 180));
      moved = now;
    }
    if (strobe && !low) {
      REQUIRE((now - moved) * 20 >= 30);
      fell = now;
      wrote = !pins.wr_n;
    }
    if (!strobe && low) {
      REQUIRE(std::abs((now - fell) * 20 - 5500) <= 100);
      if (wrote) REQUIRE((now - moved) * 20 >= 50);
      ++(wrote ? writes : reads);
      rose = now;
    }
    low = strobe;
    was = pins;
  }
};

}  // namespace

TEST_CASE("F-12 mcafee_xy: every RD and WR is 5.5 us, data stand 50 ns before and 120 ns after") {
  Bench bench;
  bench.start();
  Scope scope;
  scope.was = bench.chip.twin().port();
  bench.watch = [&](std::int64_t now) { scope.look(now, bench.chip.twin().port()); };
  Random random(91);
  for (int n = 0; n < 60; ++n) {
    ordered(bench.x, random);
    ordered(bench.y, random);
    for (int k = 0; k < 10; ++k) wild(bench, random);
  }
  CHECK(scope.writes > 500);
  CHECK(scope.reads > 500);
}

// For more of it, or other: TRAMMEL_TEST_TRANSFERS, TRAMMEL_TEST_SEED.
TEST_CASE("mcafee_xy has the pins and bytes of its twin over random transfers, leaping") {
  Bench bench;
  run_random(bench, traffic(trials(300), 92));
  if (!own_traffic()) return;
  CHECK(bench.samples(0) > trials(40));
  CHECK(bench.samples(1) > trials(40));
}

TEST_CASE("mcafee_xy has the pins and bytes of its twin over random transfers, not leaping") {
  Bench bench;
  bench.chip.leaps = false;
  run_random(bench, {25, 93});
}

TEST_CASE("mcafee_xy: the parts answer separately, and a strobe that starts nothing is reported") {
  Bench bench;
  REQUIRE(bench.read(reg::kId) == reg::kIdValue);
  bench.start();
  bench.move_to(0, 37);
  bench.move_to(1, -5);
  bench.sample();
  bench.sample();
  CHECK(bench.x.ask_long(Lm628Command::kRdrp) == 37);
  CHECK(bench.y.ask_long(Lm628Command::kRdrp) == -5);
  CHECK((bench.read(reg::kStatus) & reg::kStatusRefused) == 0);
  bench.write(reg::kPortB, reg::kPortBReadStrobe);  // the direction is that of a write
  CHECK((bench.read(reg::kStatus) & (reg::kStatusRefused | reg::kStatusBusy)) ==
        reg::kStatusRefused);
  bench.write(reg::kStatus, reg::kStatusRefused);
  CHECK((bench.read(reg::kStatus) & reg::kStatusRefused) == 0);
}

// McAfee 1994, appendix B: reads the position for ever.
TEST_CASE("F-06 mcafee_xy reads FF FF FF FB again and again while the encoder holds -5") {
  Bench bench;
  bench.start();
  bench.move_to(0, -5);
  bench.sample();
  bench.sample();
  for (int n = 0; n < 3; ++n) {
    bench.x.command(Lm628Command::kRdrp);
    CHECK(bench.x.read_word() == 0xFFFF);
    CHECK(bench.x.read_word() == 0xFFFB);
  }
}

TEST_CASE("mcafee_xy shows limit switches, interrupts and their sources") {
  Bench bench;
  bench.start();
  for (unsigned limits = 0; limits < 16; ++limits) {
    bench.chip.in.limit_i = static_cast<std::uint8_t>(limits);
    bench.clocks(3);
    CHECK(bench.read(reg::kLimits) == limits);
  }
  CHECK(bench.read(reg::kIrq) == 0);
  for (Lm628Port* part : {&bench.x, &bench.y}) {
    part->command(Lm628Command::kLtrj, 0);
    part->command(Lm628Command::kStt);  // holds
    part->command(Lm628Command::kLpei, 0);
    part->command(Lm628Command::kMski, 0x20);
    bench.move_to(part == &bench.y, 3);
    bench.sample();
    bench.sample();
    CHECK(bench.chip.twin().irq());
    CHECK(bench.read(reg::kIrq) == (part == &bench.y ? reg::kIrqY : reg::kIrqX));
    part->command(Lm628Command::kMski, 0);
    part->command(Lm628Command::kRsti, 0);
    while ((part->status() & 1) != 0) {
    }
    CHECK_FALSE(bench.chip.twin().irq());
  }
}

TEST_CASE("mcafee_xy gives the feed rate 26 clocks after a write, and that of the last write") {
  Bench bench;
  CHECK(bench.read(reg::kFeedOut) == 0);
  const auto expected = [](unsigned c, unsigned cc) {
    const FeedRate::In in{static_cast<int>(c), static_cast<int>(cc)};
    return reg::kFeedOutReady | static_cast<std::uint32_t>(FeedRate().step(in).v);
  };
  for (unsigned n = 0; n < 64; ++n) {
    const unsigned c = n * 37 & 255, cc = n * 101 & 255;
    bench.write(reg::kFeedIn, cc << 8 | c);
    CHECK(bench.read(reg::kFeedOut) == 0);
    bench.clocks(n % 24);
    bench.write(reg::kFeedIn, c << 8 | cc);  // before the first is done
    bench.clocks(48);
    CHECK(bench.read(reg::kFeedOut) == expected(cc, c));
  }
  bench.write(reg::kFeedIn, 0x4020);
  bench.clocks(23);  // two more of the two transfers
  CHECK(bench.read(reg::kFeedOut) == 0);
  bench.write(reg::kFeedIn, 0x4020);
  bench.clocks(24);
  CHECK(bench.read(reg::kFeedOut) == expected(0x20, 0x40));
}

TEST_CASE("mcafee_xy samples both axes at once, every 2048 ticks of 6 MHz") {
  Bench bench;
  bench.clocks(12345);
  bench.start();
  bench.sample();
  const std::int64_t begin = bench.now(), samples = bench.samples(0);
  for (int n = 0; n < 30; ++n) {
    bench.sample();
    REQUIRE(bench.samples(1) - bench.samples(0) == 0);
  }
  CHECK(bench.samples(0) - samples == 30);
  CHECK(bench.now() - begin == 30 * 2048 * 25 / 3);
  CHECK((bench.read(reg::kStatus) & reg::kStatusSample) != 0);
  bench.write(reg::kStatus, reg::kStatusSample);
  CHECK((bench.read(reg::kStatus) & reg::kStatusSample) == 0);
  bench.sample();
  CHECK((bench.read(reg::kStatus) & reg::kStatusSample) != 0);
}

// A program waits for STATUS.sample before it loads the next row: a sample of Y must not pass for
// one of X, nor be asked for.
TEST_CASE("mcafee_xy: STATUS.sample tells the samples of X alone, also when one part was reset") {
  for (const std::size_t reset : {0u, 1u}) {
    Bench bench;
    bench.start();
    bench.sample();
    Lm628Port& part = reset == 0 ? bench.x : bench.y;
    part.command(Lm628Command::kReset);
    bench.write(reg::kStatus, reg::kStatusSample);
    CHECK((bench.read(reg::kStatus) & reg::kStatusSample) == 0);
    std::array<int, 2> seen{};
    for (int n = 0; n < 12; ++n) {  // its reset routine, and on; the samples part by then
      const std::array<std::int64_t, 2> before{bench.samples(0), bench.samples(1)};
      while (bench.samples(0) == before[0] && bench.samples(1) == before[1]) bench.clocks(1);
      const bool x = bench.samples(0) != before[0], y = bench.samples(1) != before[1];
      CAPTURE(reset, n, x, y, bench.now());
      REQUIRE_FALSE((x && y));
      CHECK(((bench.read(reg::kStatus) & reg::kStatusSample) != 0) == x);
      bench.write(reg::kStatus, reg::kStatusSample);
      REQUIRE((bench.read(reg::kStatus) & reg::kStatusSample) == 0);
      seen[0] += x;
      seen[1] += y;
    }
    CHECK(std::min(seen[0], seen[1]) > 2);
    CHECK(std::max(seen[0], seen[1]) > 6);
  }
}

// McAfee 1994, appendix C: 66 revolutions of 800 counts at 10 rev/s, on a motor that follows.
TEST_CASE("F-05 mcafee_xy moves 52 800 counts in 24 173 samples of 341.33 us") {
  TwinBench bench;
  bench.start();
  bench.follows[0] = true;
  bench.x.command(Lm628Command::kLfil, 0x0008);
  bench.x.word(0x00FF);
  bench.x.command(Lm628Command::kUdf);
  bench.x.command(Lm628Command::kMski, 0x0004);
  bench.x.command(Lm628Command::kRsti, 0);
  bench.x.command(Lm628Command::kLtrj, 0x002A);
  for (const std::int32_t value : {0x25, 0x2BB0D, 0xCE40}) bench.x.long_word(value);
  bench.x.command(Lm628Command::kStt);
  const std::int64_t begin = bench.now(), samples = bench.samples(0);
  std::int64_t fastest = 0;
  while (!bench.chip.twin().irq() && bench.samples(0) - samples < 30000) {
    bench.sample();
    fastest = std::max(fastest, bench.part(0).engine().desired().speed);
  }
  CHECK(std::abs(bench.samples(0) - samples - 24173) <= 25);
  CHECK(static_cast<double>(bench.now() - begin) * 20e-9 == Approx(8.251).margin(0.01));
  bench.sample();
  bench.sample();
  CHECK(fastest == 0x2BB0D);
  CHECK(bench.x.ask_long(Lm628Command::kRddp) == 52800);
  CHECK(bench.x.ask_long(Lm628Command::kRdrp) == 52800);
}
