// SPDX-License-Identifier: Apache-2.0
//
// The bridge between a PDP-11's bus cycles and the twin of two stepper channels.
#include <Vword_unibus.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/motion/step_table.hpp"
#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/unibus.hpp"

using trammel::exact::StepTable;
using trammel::test::Random;
using trammel::test::Unibus;

namespace {

constexpr std::uint32_t kXCount = 0764000, kXStatus = 0764002, kYCount = 0764004,
                        kYStatus = 0764006;
constexpr std::uint16_t kBusy = 010000, kForward = 020000, kEnable = 0100000;

struct Bench {
  trammel::test::Rtl<Vword_unibus> rtl;
  StepTable device;
  StepTable::In in;
  Unibus<trammel::test::Rtl<Vword_unibus>> bus{rtl, [this] { clock(); }};
  int writes = 0;

  Bench() {
    show();
    rtl.reset();
    for (int n = 0; n < 4; ++n) clock();
  }

  void show() {
    rtl->x_i = device.words(0);
    rtl->y_i = device.words(1);
    rtl->irq_i = device.irq();
    rtl->vector_i = device.vector() & 0xFF;
    rtl.eval();
  }

  void clock() {
    show();
    in.write = rtl->write_o;
    in.y = rtl->y_o;
    in.bytes = rtl->bytes_o;
    in.data = rtl->data_o;
    in.grant = rtl->grant_o;
    writes += in.write;
    rtl.tick();
    device.step(in);
    show();
  }
  void clocks(int n) {
    for (; n > 0; --n) clock();
  }
};

}  // namespace

TEST_CASE("word_unibus: words are written and read, each once, at its address alone") {
  Bench bench;
  Random random(2);
  std::uint16_t counts[2] = {0xFFFF, 0xFFFF}, status[2] = {};
  for (int n = 0; n < 400; ++n) {
    const std::uint32_t axis = random() % 2;
    const auto word = static_cast<std::uint16_t>(random());
    if (random() % 2 == 0) {
      bench.bus.dato(kXCount + 4 * axis, word);
      counts[axis] = word;
    } else {
      status[axis] = word & 0xAFFF;  // no start
      bench.bus.dato(kXStatus + 4 * axis, status[axis]);
    }
    for (std::uint32_t k = 0; k < 2; ++k) {
      REQUIRE(bench.bus.dati(kXCount + 4 * k) == counts[k]);
      REQUIRE(bench.bus.dati(kXStatus + 4 * k) == status[k]);
    }
  }
  CHECK(bench.writes == 400);
  CHECK(bench.bus.times_out(0764010));
  CHECK(bench.bus.times_out(0763776));
  CHECK(bench.bus.times_out(0164000));
}

TEST_CASE("M-14 word_unibus: a DATOB to 764003 is answered and leaves the register") {
  Bench bench;
  bench.bus.dato(kXStatus, kForward | 01234);
  bench.bus.datob(kXStatus + 1, 0377);
  bench.bus.datob(kYCount, 0);
  CHECK(bench.bus.dati(kXStatus) == (kForward | 01234));
  CHECK(bench.bus.dati(kYCount) == 0177777);
  CHECK(bench.device.err_byte() == 2);
}

TEST_CASE("M-04 word_unibus: both axes end together, BR4, vector 340 and then 344") {
  Bench bench;
  for (const std::uint32_t count : {kXCount, kYCount}) bench.bus.dato(count, 0177774);
  bench.bus.dato(kYStatus, kEnable | kBusy | 07704);
  bench.bus.dato(kXStatus, kEnable | kBusy | 07704);
  CHECK_FALSE(bench.bus.requests());
  bench.clocks(60'000);
  REQUIRE(bench.bus.requests());
  CHECK(bench.bus.interrupt() == 0340);
  REQUIRE(bench.bus.requests());
  CHECK(bench.bus.interrupt() == 0344);
  CHECK_FALSE(bench.bus.requests());
  CHECK(bench.bus.dati(kXCount) == 0177777);
}

TEST_CASE("M-02 word_unibus: a move of five steps over the bus") {
  Bench bench;
  bench.bus.dato(kXCount, 0177772);
  bench.bus.dato(kXStatus, kBusy | kForward | 07704);
  CHECK((bench.bus.dati(kXStatus) & kBusy) != 0);
  bench.clocks(70'000);
  CHECK(bench.bus.dati(kXCount) == 0177777);
  CHECK(bench.bus.dati(kXStatus) == (kForward | 07704));
}

TEST_CASE("word_unibus: a grant without a request is passed on; INTR waits for a free bus") {
  Bench bench;
  CHECK(bench.bus.interrupt() == -1);
  CHECK_FALSE(bench.rtl->bg_o);
  bench.bus.dato(kXStatus, kEnable | kBusy);  // nothing to do: done at once
  REQUIRE(bench.bus.requests());
  bench.rtl->bbsy_i = 1;  // another master is on the bus
  bench.rtl->bg_i = 1;
  bench.clocks(10);
  CHECK(bench.rtl->sack_o);
  bench.rtl->bg_i = 0;
  bench.clocks(100);
  CHECK(bench.rtl->sack_o);
  CHECK_FALSE(bench.rtl->bbsy_o);
  bench.rtl->ssyn_i = 1;  // it lets go of the bus before its device does
  bench.rtl->bbsy_i = 0;
  bench.clocks(100);
  CHECK(bench.rtl->sack_o);
  CHECK_FALSE(bench.rtl->bbsy_o);
  bench.rtl->ssyn_i = 0;
  bench.clocks(6);
  CHECK(bench.rtl->bbsy_o);
  CHECK(bench.rtl->d_o == 0340);
}
