// SPDX-License-Identifier: Apache-2.0

#include "models/exact/bus/lm628_bridge.hpp"

#include <Vlm628_bridge.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>

#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

using trammel::exact::Gap;
using trammel::exact::Lm628Bridge;
using trammel::test::Random;

namespace {

// Both in step: their outputs before the edge and after it.
struct Pair {
  trammel::test::Rtl<Vlm628_bridge> rtl;
  Lm628Bridge twin;
  Lm628Bridge::In in;
  std::int64_t clock = 0;

  Pair() {
    rtl->leap_i = 0;
    apply();
    rtl.reset();
  }

  void apply() {
    rtl->write_strobe_i = in.write_strobe;
    rtl->read_strobe_i = in.read_strobe;
    rtl->ps_i = in.ps;
    rtl->read_i = in.read;
    rtl->y_i = in.y;
    rtl->to_part_i = in.to_part;
    rtl->d_x_i = in.d_x;
    rtl->d_y_i = in.d_y;
    rtl.eval();
  }

  template <class Twin>
  void pin(const char* name, unsigned ours, Twin theirs) const {
    trammel::test::same(name, ours, theirs, clock);
  }

  // Returns the edges passed.
  Gap edge(Gap most = 1) {
    apply();
    pin("busy_o", rtl->busy_o, twin.busy(in));
    pin("refused_o", rtl->refused_o, twin.refuses(in));
    pin("quiescent_o", rtl->quiescent_o, twin.quiescent(in));
    rtl->clock_en_i = !twin.quiescent(in);  // its clock is gated where it rests
    Gap gap = twin.quiescent(in) ? std::min(twin.next(), most) : 0;
    if (gap > 1) {
      pin("next_o", rtl->next_o, twin.next());
      rtl->leap_i = (gap - 1) & 0xFFF;
      twin.advance(gap);
    } else {
      gap = 1;
      twin.step(in);
    }
    rtl.tick();
    rtl->leap_i = 0;
    rtl->clock_en_i = 1;
    rtl.eval();
    clock += gap;
    const Lm628Bridge::Out out = twin.out();
    pin("cs_x_n_o", rtl->cs_x_n_o, out.cs_x_n);
    pin("cs_y_n_o", rtl->cs_y_n_o, out.cs_y_n);
    pin("rd_n_o", rtl->rd_n_o, out.rd_n);
    pin("wr_n_o", rtl->wr_n_o, out.wr_n);
    pin("ps_o", rtl->ps_o, out.ps);
    pin("d_o", rtl->d_o, out.d);
    pin("transceiver_o", rtl->transceiver_o, out.transceiver);
    pin("selector_o", rtl->selector_o, out.selector);
    pin("from_part_o", rtl->from_part_o, twin.from_part());
    return gap;
  }

  void clocks(int n) {
    for (int i = 0; i < n; ++i) edge();
  }
  void rest() {
    while (twin.busy(in)) edge();
    edge();
  }
};

}  // namespace

TEST_CASE("lm628_bridge agrees with its twin on random ports, leaps and resets") {
  Pair pair;
  Random random(81);
  for (int i = 0; i < 60000; ++i) {
    auto& in = pair.in;
    if (random() % 16 == 0) in.write_strobe = !in.write_strobe;
    if (random() % 16 == 0) in.read_strobe = !in.read_strobe;
    if (random() % 40 == 0) in.read = !in.read;
    if (random() % 40 == 0) in.y = !in.y;
    if (random() % 40 == 0) in.ps = !in.ps;
    if (random() % 10 == 0) in.to_part = static_cast<std::uint8_t>(random());
    if (random() % 3 == 0) in.d_x = static_cast<std::uint8_t>(random());
    if (random() % 3 == 0) in.d_y = static_cast<std::uint8_t>(random());
    if (random() % 3000 == 0) {
      in.write_strobe = in.read_strobe = false;
      pair.apply();
      pair.rtl.reset();
      pair.twin.reset();
      pair.edge();
    }
    pair.edge();
    if (random() % 8 != 0) continue;
    for (int k = 0; k < 6; ++k) pair.edge(random() % 400);  // a pause
  }
}

TEST_CASE("F-08 lm628_bridge selects X or Y, drives or listens, never both, with a clock between") {
  Pair pair;
  for (int n = 0; n < 64; ++n) {
    pair.in.y = n % 2 == 1;
    pair.in.read = n / 2 % 2 == 1;
    int none = 0;
    for (int clock = 0; clock < 4; ++clock) {
      const auto before = pair.twin.out();
      pair.edge();
      REQUIRE((pair.rtl->cs_x_n_o || pair.rtl->cs_y_n_o));
      REQUIRE_FALSE((pair.rtl->transceiver_o && pair.rtl->selector_o));
      REQUIRE_FALSE((!pair.rtl->cs_x_n_o && !before.cs_y_n));
      REQUIRE_FALSE((pair.rtl->selector_o && before.transceiver));
      none += pair.rtl->cs_x_n_o && pair.rtl->cs_y_n_o;
    }
    REQUIRE(bool(pair.rtl->cs_x_n_o) == pair.in.y);
    REQUIRE(bool(pair.rtl->cs_y_n_o) != pair.in.y);
    REQUIRE(bool(pair.rtl->selector_o) == pair.in.read);
    REQUIRE(bool(pair.rtl->transceiver_o) != pair.in.read);
    REQUIRE(none == (n == 0 ? 0 : 1));
    REQUIRE(bool(pair.rtl->wr_n_o));
    REQUIRE(bool(pair.rtl->rd_n_o));
  }
}

TEST_CASE("lm628_bridge holds the pins through a pulse, whatever is written to the ports") {
  Pair pair;
  pair.in.ps = true;
  pair.in.to_part = 0xA5;
  pair.in.write_strobe = true;
  pair.edge();
  pair.in = {false, false, false, true, true, 0x5A, 0, 0};
  int low = 0;
  do {
    pair.edge();
    low += !pair.rtl->wr_n_o;
    REQUIRE_FALSE(bool(pair.rtl->cs_x_n_o));
    REQUIRE(bool(pair.rtl->transceiver_o));
    REQUIRE(bool(pair.rtl->ps_o));
    REQUIRE(pair.rtl->d_o == 0xA5);
  } while (pair.rtl->busy_o);
  REQUIRE(low == 275);
  pair.clocks(2);
  REQUIRE_FALSE(bool(pair.rtl->cs_y_n_o));
  REQUIRE(bool(pair.rtl->selector_o));
  REQUIRE(pair.rtl->d_o == 0x5A);
}

TEST_CASE("lm628_bridge refuses a strobe while a pulse runs, and one against the direction") {
  Pair pair;
  pair.in.write_strobe = true;
  pair.edge();
  pair.in.write_strobe = false;
  pair.clocks(100);
  pair.in.write_strobe = true;  // a 74LS123 would restart
  pair.apply();
  REQUIRE(bool(pair.rtl->refused_o));
  int low = 0;
  for (int n = 0; n < 1000; ++n) {
    pair.edge();
    low += !pair.rtl->wr_n_o;
  }
  REQUIRE(low == 275 - 99);  // the first of the 100 clocks was set-up time
  for (const bool read : {false, true}) {
    pair.in = {false, false, false, read, false, 0, 0x12, 0x34};
    pair.rest();
    (read ? pair.in.write_strobe : pair.in.read_strobe) = true;
    pair.apply();
    REQUIRE(bool(pair.rtl->refused_o));
    REQUIRE_FALSE(bool(pair.rtl->busy_o));
    for (int n = 0; n < 400; ++n) {
      pair.edge();
      REQUIRE((pair.rtl->rd_n_o && pair.rtl->wr_n_o));
    }
  }
}

TEST_CASE("lm628_bridge takes the selected part's byte as it is when RD ends") {
  Pair pair;
  for (const bool y : {false, true}) {
    pair.in = {false, false, false, true, y, 0, 0x11, 0x22};
    pair.rest();
    pair.in.read_strobe = true;
    pair.edge();
    pair.in.read_strobe = false;
    while (pair.rtl->rd_n_o) pair.edge();
    for (int n = 0; n < 274; ++n) pair.edge();
    REQUIRE_FALSE(bool(pair.rtl->rd_n_o));
    (y ? pair.in.d_y : pair.in.d_x) = 0x77;
    pair.edge();
    REQUIRE(bool(pair.rtl->rd_n_o));
    pair.in.d_x = pair.in.d_y = 0xFF;
    pair.rest();
    REQUIRE(pair.rtl->from_part_o == 0x77);
  }
}
