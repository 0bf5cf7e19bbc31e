// SPDX-License-Identifier: Apache-2.0

#include <Vlm628_wishbone.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "tests/bus/lm628_wrapped.hpp"
#include "tests/chips/lm628_transfers.hpp"

using trammel::test::Opcode;
using trammel::test::Random;

namespace {

class Bench : public trammel::test::Wrapped<Vlm628_wishbone>,
              public trammel::test::Lm628Commands<Bench> {
 public:
  explicit Bench(std::uint32_t seed) : Wrapped(seed) {
    idle();
    start();
  }

  void write(bool ps, std::uint8_t byte) { cycle(true, ps, byte, 1 | (random() & 0xE)); }
  std::uint8_t read(bool ps) {
    cycle(false, ps, 0, 1);
    return given();
  }
  void clocks(std::int64_t n) {
    idle();
    pass(n);
  }

  // One cycle up to its acknowledge; returns the clocks that it took.
  int cycle(bool write, bool ps, std::uint8_t byte, unsigned sel) {
    put(write, ps, byte, sel);
    int clocks = 0;
    for (;; edge()) {
      rtl.eval();
      ++clocks;
      if (rtl->ack_o) break;
      REQUIRE(clocks < 60);
    }
    if (!write && (sel & 1) != 0) REQUIRE(rtl->dat_o == given());
    edge();
    if (random() % 2 == 0) {  // else the next one follows at once
      idle();
      pass(random() % 4);
    }
    return clocks;
  }

  // One that its master gives up after some clocks, before the acknowledge or as it comes.
  void give_up(bool write, bool ps, std::uint8_t byte, int clocks) {
    put(write, ps, byte, 1);
    for (int i = 0; i < clocks; ++i) {
      edge();
      if (i + 1 == clocks) idle();
      rtl.eval();
      REQUIRE_FALSE(rtl->ack_o);
    }
    asks_ = true;  // an acknowledge that nobody waits for lasts a clock inside
    edge();
    asks_ = false;
    REQUIRE_FALSE(rtl->ack_o);
  }

  void idle() {
    asks_ = false;
    (random() % 2 == 0 ? rtl->cyc_i : rtl->stb_i) = 0;
    rtl->we_i = random() % 2;
    rtl->adr_i = random() % 2;
    rtl->sel_i = random() & 0xF;
    rtl->dat_i = random();
  }

 private:
  bool bus_idle() override { return !asks_; }
  void put(bool write, bool ps, std::uint8_t byte, unsigned sel) {
    rtl->cyc_i = rtl->stb_i = 1;
    rtl->we_i = write;
    rtl->adr_i = ps;
    rtl->sel_i = sel & 0xF;
    rtl->dat_i = (random() & 0xFFFFFF00) | byte;
    asks_ = true;
    if ((sel & 1) != 0) expect(write, ps, byte);
  }

  bool asks_ = false;
};

}  // namespace

TEST_CASE("lm628_wishbone does with its part what the bare port does, over 400 random transfers") {
  Bench bench(95);
  Random random(96);
  for (int n = 0; n < 400; ++n) {
    CAPTURE(n);
    if (random() % 8 == 0) {
      trammel::test::wild(bench, random);
    } else {
      bench.ready();
      trammel::test::ordered(bench, random);
    }
    if (random() % 10 == 0) REQUIRE(bench.cycle(random() % 2 == 0, true, 0x55, 0xE) <= 2);
    if (random() % 4 == 0) bench.clocks(random() % 20'000);
  }
  CHECK(bench.accesses() > 2000);
  bench.clocks(40);
  CHECK(bench.all_done());
}

TEST_CASE("lm628_wishbone interrupts while HI is high, two clocks later") {
  Bench bench(97);
  bench.clear_status();
  bench.command(Opcode::kMski, {0x0004});
  bench.command(Opcode::kStt);
  bench.idle();
  int high = 0;
  for (int i = 0; i < 30'000; ++i) {
    bench.edge();
    REQUIRE((bench.rtl->irq_o != 0) == bench.hi());
    high += bench.rtl->irq_o;
  }
  CHECK(high > 100);
  bench.clear_status();
  bench.clocks(3);
  CHECK(bench.rtl->irq_o == 0);
}

TEST_CASE("lm628_wishbone ends an access whose cycle was given up, without an acknowledge") {
  Bench bench(98);
  // A write would be acknowledged after edge 14, a read after 21.
  for (int clocks = 1; clocks <= 21; ++clocks) {
    CAPTURE(clocks);
    bench.ready();
    const int before = bench.accesses();
    const bool writes = clocks == 14 || (clocks % 3 == 0 && clocks < 13);
    if (writes) {
      bench.give_up(true, false, 0x0B, clocks);  // RDRV, of which the reply is left
    } else {
      bench.give_up(false, false, 0, clocks);
    }
    const std::uint8_t status = bench.status();
    CHECK((status & 0x80) != 0);
    CHECK(bench.accesses() == before + 2);
    bench.clocks(1200);
    if (writes) CHECK(bench.read_word() == 0);
  }
}

TEST_CASE("lm628_wishbone acknowledges a write after 15 clocks, a read after 22, nothing after 2") {
  Bench bench(99);
  bench.clocks(50);
  CHECK(bench.cycle(true, false, 0x0A, 1) == 15);
  bench.clocks(50);
  CHECK(bench.cycle(false, false, 0, 1) == 22);
  bench.clocks(50);
  CHECK(bench.cycle(true, false, 0, 0xE) == 2);
}
