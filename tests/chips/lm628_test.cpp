// SPDX-License-Identifier: Apache-2.0
//
// The chip beside its twin, pin by pin: the first acceptance scenarios, and random transfers.

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <map>

#include "tests/chips/lm628_pair.hpp"
#include "tests/chips/lm628_transfers.hpp"
#include "tests/support/checked.hpp"

using trammel::exact::Opcode;
using trammel::test::Lm628Pair;
using trammel::test::own_traffic;
using trammel::test::run_random;
using trammel::test::traffic;
using trammel::test::trials;
using Bench = trammel::test::Lm628Bench<Lm628Pair>;

// AN-693, "Initialize": status 84h within 1.5 ms, 80h after RSTI.
TEST_CASE("L-01 lm628 reset: status 00, then 84h within 1.5 ms, then 80h after RSTI 0000") {
  Bench bench;
  bench.hardware_reset(50);  // 8 ticks
  REQUIRE(bench.status() == 0);
  bench.clocks(40000);
  REQUIRE(bench.status() == 0);
  bench.write(false, Bench::code(Opcode::kPort12));  // ignored
  bench.clocks(20000);
  REQUIRE(bench.status() == 0x84);
  REQUIRE_FALSE(bench.out().hi);
  bench.clear_status();
  REQUIRE(bench.status() == 0x80);
  REQUIRE(bench.out().drive.dac == 0x80);
  REQUIRE((bench.ask(Opcode::kRdsigs) & 0x0100) != 0);
  bench.write(false, Bench::code(Opcode::kReset));  // the same by command, but busy
  bench.clocks(10);
  REQUIRE(bench.status() == 0x01);
  bench.clocks(49900);
  REQUIRE(bench.status() == 0x01);
  bench.clocks(100);
  REQUIRE(bench.status() == 0x84);
}

// The data sheet's: words written, words read.
struct Words {
  int due, replied;
};
const std::map<unsigned, Words> kOpcodes{
    {0x00, {0, 0}}, {0x01, {0, 0}}, {0x02, {0, 0}}, {0x03, {0, 0}}, {0x04, {0, 0}}, {0x05, {0, 0}},
    {0x06, {0, 0}}, {0x07, {0, 2}}, {0x08, {0, 2}}, {0x09, {0, 2}}, {0x0A, {0, 2}}, {0x0B, {0, 1}},
    {0x0C, {0, 1}}, {0x0D, {0, 1}}, {0x1A, {1, 0}}, {0x1B, {1, 0}}, {0x1C, {1, 0}}, {0x1D, {1, 0}},
    {0x1E, {1, 0}}, {0x1F, {1, 0}}, {0x20, {2, 0}}, {0x21, {2, 0}}};

TEST_CASE("L-02 lm628 takes every opcode with its words without command error, not one more") {
  Bench bench;
  for (unsigned op = 0; op < 512; ++op) {
    const auto byte = static_cast<std::uint8_t>(op);
    CAPTURE(op);
    bench.start();
    bench.write(false, byte);
    bench.ready();
    const auto known = kOpcodes.find(byte);
    if (known == kOpcodes.end()) {
      REQUIRE((bench.status() & 2) != 0);
      continue;
    }
    for (int n = 0; n < known->second.due; ++n) bench.word(0);  // a control word asks for nothing
    for (int n = 0; n < known->second.replied; ++n) bench.read_word();
    REQUIRE((bench.status() & 2) == 0);
    if (op < 256) {
      bench.read(true);
    } else {
      bench.write(true, 0);
    }
    REQUIRE((bench.status() & 2) != 0);
  }
}

TEST_CASE("L-02 lm628 takes for LFIL and LTRJ the words that their control words ask for") {
  Bench bench;
  bench.start();
  for (unsigned control = 0; control < 64; ++control) {
    for (const Opcode opcode : {Opcode::kLfil, Opcode::kLtrj}) {
      if (opcode == Opcode::kLfil && control > 15) continue;
      const unsigned loads = opcode == Opcode::kLfil ? 0x0F : 0x2A;
      int words = 0;
      for (unsigned bit = 1; bit < 64; bit *= 2) words += (control & loads & bit) != 0;
      if (opcode == Opcode::kLtrj) words *= 2;
      CAPTURE(control, words);
      bench.clear_status();
      bench.command(opcode, {control});
      for (int n = 0; n < words; ++n) bench.word(1);
      REQUIRE((bench.status() & 2) == 0);
      bench.write(true, 0);
      REQUIRE((bench.status() & 2) != 0);
    }
  }
}

TEST_CASE("L-03 lm628 ignores writes while it is busy, without command error") {
  Bench bench;
  bench.start();
  bench.clear_status();
  bench.write(false, Bench::code(Opcode::kRdsigs));
  bench.write(false, Bench::code(Opcode::kPort12));
  bench.write(true, 0x55);
  bench.read(true);
  bench.ready();
  REQUIRE(bench.read_word() == 0x0180);
  REQUIRE(bench.status() == 0x80);
  REQUIRE(bench.ask(Opcode::kRdsigs) == 0x0180);
}

TEST_CASE("L-03 lm628 is busy for 160 ticks, longer where a sample is computed") {
  Bench bench;
  bench.start();
  for (const int after : {100, 3000, 11000, 11700, 11900}) {
    bench.sample();
    bench.clocks(12800 - 2500 + after);                  // from tick 0 on
    const std::int64_t begin = bench.now() + 2 + 5 + 3;  // the strobe's end is seen
    const std::int64_t tick0 = bench.now() - after;
    bench.write(false, Bench::code(Opcode::kUdf));
    bench.ready();
    const std::int64_t fall = std::max(begin + 1000, tick0 + 2500 + (after > 11000 ? 12800 : 0));
    const bool late = (begin + 1000 - tick0) % 12800 < 2500;
    const std::int64_t expected = late ? fall : begin + 1000;
    CAPTURE(after, bench.now() - begin, expected - begin);
    REQUIRE(bench.now() >= expected);
    REQUIRE(bench.now() < expected + 140);  // a poll
  }
}

TEST_CASE("lm628 drops a transfer that a command interrupts, and no half word at a status read") {
  Bench bench;
  bench.start();
  bench.clear_status();
  bench.command(Opcode::kSbpa, {0x0001});  // one of two words
  bench.command(Opcode::kRdsigs);
  REQUIRE((bench.status() & 2) != 0);
  bench.read_word();
  bench.clear_status();
  bench.command(Opcode::kMski);
  bench.write(true, 0x00);
  REQUIRE(bench.status() == 0x80);
  bench.write(true, 0x40);
  bench.ready();
  REQUIRE(bench.status() == 0x80);
  bench.write(false, 0x3F);  // unknown
  bench.ready();
  REQUIRE(bench.status() == 0x82);
  REQUIRE_FALSE(bench.out().hi);  // only the breakpoint interrupts
}

// For more of it, or other: TRAMMEL_TEST_TRANSFERS, TRAMMEL_TEST_SEED.
TEST_CASE("L-15 lm628 has the pins of its twin over 10,000 random transfers, leaping") {
  Bench bench;
  run_random(bench, traffic(trials(10000), 61));
  if (own_traffic()) CHECK(bench.samples() > trials(4000));
}

TEST_CASE("L-15 lm628 has the pins of its twin over 200 random transfers, not leaping") {
  Bench bench;
  bench.chip.leaps = false;
  run_random(bench, {200, 62});
}
