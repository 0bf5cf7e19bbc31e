// SPDX-License-Identifier: Apache-2.0
//
// Acceptance scenarios of the LM628: data sheet SNVS781C, application note AN-693. Short ones run
// on the RTL beside its twin, long ones on the twin.

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>

#include "tests/chips/lm628_pair.hpp"

using trammel::exact::Opcode;
using trammel::test::Lm628Pair;
using trammel::test::Lm628Twin;
using Bench = trammel::test::Lm628Bench<Lm628Pair>;
using TwinBench = trammel::test::Lm628Bench<Lm628Twin>;

namespace {

template <class AnyBench>
void filter(AnyBench& bench, unsigned kp, unsigned ki = 0, unsigned kd = 0, unsigned il = 0,
            unsigned n = 0) {
  bench.command(Opcode::kLfil, {n << 8 | 0x0F, kp, ki, kd, il});
  bench.command(Opcode::kUdf);
}

// The loop is closed where the motor stands.
template <class AnyBench>
void hold(AnyBench& bench) {
  bench.trajectory(0, {});
  bench.command(Opcode::kStt);
  bench.sample(2);
}

template <class AnyBench>
int samples_until_irq(AnyBench& bench, int patience) {
  int n = 0;
  for (; !bench.out().hi && n < patience; ++n) bench.sample();
  return n;
}

unsigned dac12(Bench& bench) {
  unsigned code = 0;
  bool wr_n = true;
  bench.sample();
  for (int i = 0; i < 300; ++i) {
    const auto out = bench.out().drive;
    if (!wr_n && out.dac_wr_n) code |= static_cast<unsigned>(out.dac >> 2) << (out.dac_hi_lo * 6);
    wr_n = out.dac_wr_n;
    bench.clocks(1);
  }
  return code;
}

}  // namespace

// AN-693, "Filter programming": kp = 10.
TEST_CASE("L-04 lm628 output: 80h before UDF, then 83h and 83Eh at +100, 7Ch and 7C1h at -100") {
  for (const int error : {100, -100}) {
    Bench bench;
    bench.start();
    hold(bench);
    bench.command(Opcode::kLfil, {0x0008, 10});
    bench.move_to(-error);
    bench.sample(2);
    REQUIRE(bench.out().drive.dac == 0x80);
    bench.command(Opcode::kUdf);
    bench.sample(2);
    REQUIRE(bench.engine().output() == (error > 0 ? 0x3E8 : -0x3E8));
    REQUIRE(bench.out().drive.dac == (error > 0 ? 0x83 : 0x7C));
    bench.command(Opcode::kPort12);
    bench.sample();
    REQUIRE(dac12(bench) == (error > 0 ? 0x83E : 0x7C1));
  }
}

// Data sheet: 600 rpm, 1 rev/s^2, 100 revolutions of 2000 counts take 19.54 s.
TEST_CASE("L-05 lm628 ends the data sheet's move at 200 000 after 76 345 samples") {
  TwinBench bench;
  bench.start();
  bench.follows = true;
  filter(bench, 10);
  bench.clear_status();
  bench.command(Opcode::kMski, {0x0004});
  bench.trajectory(0x002A, {9, 0x51EB8, 0x30D40});
  bench.command(Opcode::kStt);
  std::int64_t fastest = 0;
  int n = 0;
  for (; !bench.out().hi && n < 80000; ++n) {
    bench.sample();
    fastest = std::max(fastest, bench.engine().desired().speed);
  }
  CHECK(std::abs(n - 76345) <= 80);
  CHECK(fastest == 0x51EB8);
  bench.sample(2);
  CHECK(bench.ask(Opcode::kRddp) == 200000);
  CHECK(bench.ask(Opcode::kRdrp) == 200000);
  CHECK(bench.status() == 0x04);
}

// AN-693, "Velocity profile with breakpoints", on a motor that is at its desired position.
TEST_CASE("L-06 lm628 goes through the three speeds of AN-693 at 80 000 and 160 000") {
  TwinBench bench;
  bench.start();
  bench.follows = true;
  filter(bench, 10);
  bench.command(Opcode::kMski, {0x0040});
  bench.command(Opcode::kSbpa, {80000 >> 16, 80000 & 0xFFFF});
  bench.trajectory(0x1828, {0x11, 0x20C4A});
  bench.command(Opcode::kStt);
  int n = samples_until_irq(bench, 50000);
  CHECK(std::abs(n - 43010) <= 30);
  CHECK(bench.engine().actual() >= 80000);
  CHECK(bench.engine().actual() <= 80003);
  bench.clear_status();
  bench.command(Opcode::kSbpa, {160000 >> 16, 160000 & 0xFFFF});
  bench.trajectory(0x180C, {0x20C4A});
  bench.command(Opcode::kStt);
  n += samples_until_irq(bench, 50000);
  CHECK(std::abs(n - 64515) <= 30);
  CHECK(bench.engine().actual() >= 160000);
  CHECK(bench.engine().actual() <= 160005);
  bench.clear_status();
  bench.trajectory(0x0400, {});
  bench.command(Opcode::kStt);
  for (; !bench.engine().signals().on_target && n < 90000; ++n) bench.sample();
  CHECK(std::abs(n - 80306) <= 30);
  bench.sample(2);
  CHECK(std::abs(bench.ask(Opcode::kRdrp) - 192338) <= 60);
}

// AN-693, "Stop".
TEST_CASE("L-07 lm628 stops: output off, at once, or in V/A = 7 895 samples") {
  for (const unsigned stop : {0x100U, 0x200U, 0x400U}) {
    TwinBench bench;
    bench.start();
    bench.follows = true;
    filter(bench, 1000);
    bench.trajectory(0x1828, {0x11, 0x20C4A});
    bench.command(Opcode::kStt);
    while (bench.engine().desired().speed < 0x20C4A) bench.sample();
    bench.clear_status();
    bench.trajectory(stop, {});
    bench.sample();
    CAPTURE(stop);
    REQUIRE(bench.out().drive.dac != 0x80);
    bench.command(Opcode::kStt);
    int n = 0;
    while (bench.engine().desired().speed != 0 && n < 9000) {
      bench.sample();
      ++n;
      if (stop == 0x100) REQUIRE(bench.out().drive.dac == 0x80);
    }
    CHECK(std::abs(n - (stop == 0x400 ? 7895 : stop == 0x200 ? 0 : 1)) <= (stop == 0x400 ? 3 : 0));
    bench.sample();
    CHECK(bench.status() == (stop == 0x100 ? 0x84 : 0x04));
    if (stop == 0x100) CHECK(bench.out().drive.dac == 0x80);
  }
}

TEST_CASE("L-08 lm628 with a blocked rotor: LPEI reports an error of 101, LPES turns it off") {
  for (const bool stops : {false, true}) {
    Bench bench;
    bench.start();
    filter(bench, 100);
    bench.command(stops ? Opcode::kLpes : Opcode::kLpei, {100});
    bench.clear_status();
    bench.trajectory(0x1828, {65536, 65536});
    bench.command(Opcode::kStt);
    while ((bench.status() & 0x20) == 0) bench.sample();
    CAPTURE(stops);
    REQUIRE(bench.engine().error() == 101);
    REQUIRE(bench.status() == (stops ? 0xA4 : 0x20));
    REQUIRE(bench.out().drive.dac == (stops ? 0x80 : 0x80 + 10100 / 256));
    REQUIRE((bench.ask(Opcode::kRdsigs) & 0x0200) == (stops ? 0x0200 : 0));
  }
}

// The index is taken where A, B and the index are low together; counts 4 k are where A and B are.
TEST_CASE("L-09 lm628 captures the first index after SIP at count 1 234 and no other") {
  Bench bench;
  bench.move_to(2);  // A = B = 1
  bench.start();
  bench.clear_status();
  bench.set_index(1236);
  bench.command(Opcode::kSip);
  REQUIRE((bench.ask(Opcode::kRdsigs) & 1) == 1);
  bench.move_to(1300, 8);
  bench.sample(2);
  REQUIRE(bench.ask(Opcode::kRdip) == 1234);  // two counts from the start
  REQUIRE(bench.status() == 0x88);
  REQUIRE((bench.ask(Opcode::kRdsigs) & 1) == 0);
  bench.move_to(1000, 8);
  bench.set_index(1100);
  bench.move_to(1200, 8);
  bench.sample(2);
  REQUIRE(bench.ask(Opcode::kRdip) == 1234);
  bench.command(Opcode::kDfh);
  REQUIRE(bench.ask(Opcode::kRdip) == 1234);
  REQUIRE(bench.ask(Opcode::kRdrp) == 0);
}

TEST_CASE("lm628 takes no index while a line of the encoder is high") {
  for (const int count : {1, 2, 3}) {  // A, both, B
    Bench bench;
    bench.start();
    bench.clear_status();
    bench.set_index(count);
    bench.command(Opcode::kSip);
    bench.move_to(8, 8);
    bench.sample(2);
    CAPTURE(count);
    REQUIRE((bench.ask(Opcode::kRdsigs) & 1) == 1);
    REQUIRE((bench.status() & 0x08) == 0);
  }
}

TEST_CASE("L-10 lm628 refuses a new acceleration in motion, which continues unchanged") {
  Bench asked, left;
  for (Bench* bench : {&asked, &left}) {
    bench->start();
    bench->follows = true;
    bench->trajectory(0x002A, {3000, 300000, 40});
    bench->command(Opcode::kStt);
  }
  asked.trajectory(0x002A, {9000, 900000, 400});
  asked.command(Opcode::kStt);
  left.clocks(asked.now() - left.now());
  for (int n = 0; n < 60; ++n) {
    asked.sample();
    left.sample();
    REQUIRE(asked.engine().desired().position == left.engine().desired().position);
    REQUIRE(asked.engine().desired().speed == left.engine().desired().speed);
  }
  REQUIRE(left.engine().desired().position == std::int64_t{40} << 16);
}

TEST_CASE("L-10 lm628 refuses a new acceleration in motion and takes it at rest") {
  Bench bench;
  bench.start();
  bench.follows = true;
  bench.trajectory(0x002A, {3000, 300000, 40});
  bench.command(Opcode::kStt);
  bench.sample(3);
  bench.clear_status();
  bench.trajectory(0x002A, {9000, 900000, 400});
  bench.command(Opcode::kStt);
  REQUIRE(bench.status() == 0x02);
  REQUIRE((bench.ask(Opcode::kRdsigs) & 0x4000) != 0);
  while (!bench.engine().signals().on_target) bench.sample();
  REQUIRE(bench.ask(Opcode::kRddp) == 40);
  bench.clear_status();
  bench.command(Opcode::kStt);
  bench.sample();
  REQUIRE(bench.status() == 0x00);
  while (!bench.engine().signals().on_target) bench.sample();
  REQUIRE(bench.ask(Opcode::kRddp) == 400);
}

TEST_CASE("L-11 lm628 interrupts once for the event of its mask, until RSTI") {
  Bench bench;
  bench.start();
  bench.follows = true;
  bench.command(Opcode::kMski, {0x0004});
  bench.clear_status();
  bench.command(Opcode::kSbpa, {0, 20});
  bench.trajectory(0x002A, {3000, 300000, 40});
  bench.command(Opcode::kStt);
  int rises = 0;
  bool was = false;
  while (!bench.engine().signals().on_target) {
    bench.sample();
    if ((bench.status() & 0x44) == 0x40) REQUIRE_FALSE(bench.out().hi);
    rises += bench.out().hi && !was;
    was = bench.out().hi;
  }
  bench.sample(3);
  REQUIRE(rises == 1);
  REQUIRE(bench.out().hi);
  REQUIRE(bench.status() == 0x44);
  bench.command(Opcode::kRsti, {0x007B});
  REQUIRE_FALSE(bench.out().hi);
  REQUIRE(bench.status() == 0x40);
}

// States 1 to 4 have (A, B) = 01, 11, 10, 00; A leads forward.
TEST_CASE("L-12 lm628 counts every transition, 4 3 2 1 forward and 4 1 2 3 backward") {
  for (const int direction : {1, -1}) {
    Bench bench;
    const int start = direction > 0 ? 3 : 1;  // state 1, state 3
    bench.move_to(start);
    bench.start();
    for (int n = 1; n <= 4000; ++n) {
      bench.move_to(start + direction * n, 4);
      if (n > 8 && n < 4000) continue;
      bench.sample(2);
      REQUIRE(bench.ask(Opcode::kRdrp) == direction * n);
    }
  }
}

TEST_CASE("L-13 lm628 integral grows by one a sample at an error of 256 and stops at its limit") {
  Bench bench;
  bench.start();
  hold(bench);
  filter(bench, 0, 1, 0, 50);
  bench.move_to(-256);
  std::int64_t before = bench.engine().output();
  for (int n = 0; n < 60; ++n) {
    bench.sample();
    const std::int64_t now = bench.engine().output();
    if (n > 1) REQUIRE(now == std::min<std::int64_t>(before + 1, 50));
    before = now;
  }
  REQUIRE(before == 50);
  REQUIRE(bench.ask(Opcode::kRdsum) >= 59);
}

TEST_CASE("L-14 lm628 derivative of a ramp is 40 at n = 3 and kd = 10, taken every 4th sample") {
  Bench bench;
  bench.start();
  hold(bench);
  filter(bench, 0, 0, 10, 0, 3);
  std::int64_t position = 0;
  int changes = 0;
  for (int n = 0; n < 40; ++n) {
    bench.move_to(--position);
    const std::int64_t before = bench.engine().output();
    bench.sample();
    if (n >= 8) REQUIRE(bench.engine().output() == 40);
    changes += bench.engine().output() != before;
  }
  REQUIRE(changes <= 2);          // the first difference may be shorter
  changes = 0;
  for (int n = 0; n < 40; ++n) {  // at rest it is 0 eight samples later at most, and stays
    const std::int64_t before = bench.engine().output();
    bench.sample();
    if (n >= 8) REQUIRE(bench.engine().output() == 0);
    changes += bench.engine().output() != before;
  }
  REQUIRE(changes <= 2);  // held between: a difference taken at each sample falls in four steps
}
