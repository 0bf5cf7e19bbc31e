// SPDX-License-Identifier: Apache-2.0

#include "models/exact/bus/lm628_port.hpp"

#include <Vlm628_port.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>

#include "tests/support/random.hpp"
#include "tests/support/rtl.hpp"
#include "tests/support/same.hpp"

using trammel::exact::Gap;
using trammel::exact::Lm628Port;
using trammel::test::Random;
using In = Lm628Port::In;

namespace {

struct Rtl : trammel::test::Rtl<Vlm628_port> {
  Rtl() {
    (*this)->leap_i = 0;
    (*this)->word_addr_i = 0;
    apply({});
  }

  void apply(const In& in) {
    auto& rtl = *this;
    rtl->cs_n_i = in.pins.cs_n;
    rtl->rd_n_i = in.pins.rd_n;
    rtl->wr_n_i = in.pins.wr_n;
    rtl->ps_i = in.pins.ps;
    rtl->d_i = in.pins.d;
    rtl->ready_i = in.ready;
    rtl->open_i = in.open;
    rtl->commit_i = in.commit;
    rtl->sample_events_i = (in.sample.events >> 1) & 0x3F;
    rtl->sample_off_i = in.sample.off;
    rtl->command_events_i = (in.command.events >> 1) & 0x3F;
    rtl->command_off_i = in.command.off;
    rtl->reply_i = in.reply;
    eval();
  }
};

// Both in step: their outputs before the edge and after it.
struct Pair {
  Rtl rtl;
  Lm628Port twin;
  In in;
  std::int64_t clock = 0;
  bool filled = false;  // every word has been written

  Pair() {
    in.ready = in.open = true;
    rtl.apply(in);
    for (int i = 0; i < 3; ++i) rtl.tick();  // the synchronisers have no reset
    reset();
  }

  void reset() {
    rtl.apply(in);
    for (int i = 0; i < 2; ++i) {
      const bool by_command = twin.restarts(in);
      twin.step(in);
      twin.reset(by_command);
    }
    rtl.reset();
  }

  template <class Ours, class Theirs>
  void pin(const char* name, Ours ours, Theirs theirs) const {
    trammel::test::same(name, ours, theirs, clock);
  }

  void edge(Gap most = 1) {
    rtl.apply(in);
    pin("restart_o", rtl->restart_o, twin.restarts(in));
    pin("start_o", rtl->start_o, twin.starts(in));
    pin("end_o", rtl->end_o, twin.ends());
    pin("arm_o", rtl->arm_o, twin.arms_index());
    pin("quiescent_o", rtl->quiescent_o, twin.quiescent(in));
    pin("status_o", rtl->status_o << 1, (twin.flags(in) & 0x7E));
    pin("host_irq_o", rtl->host_irq_o, (twin.flags(in) >= 0x8000));
    rtl->clock_en_i = !twin.quiescent(in);  // its clock is gated where it rests
    const Gap gap = twin.quiescent(in) ? std::min(twin.next(), most) : 0;
    const bool restarts = twin.restarts(in);  // the chip resets its blocks then
    if (gap > 1) {
      pin("next_o", rtl->next_o, twin.next());
      rtl->leap_i = (gap - 1) & 0xFFF;
      twin.advance(gap);
    } else {
      twin.step(in);
    }
    if (restarts) twin.reset(true);
    rtl->rst_i = restarts;
    rtl.tick();
    rtl->clock_en_i = 1;
    rtl->rst_i = 0;
    rtl->leap_i = 0;
    rtl.eval();
    clock += std::max<Gap>(gap, 1);
    pin("d_o", rtl->d_o, twin.d());
    pin("d_oe_o", rtl->d_oe_o, twin.d_oe());
    pin("hi_o", rtl->hi_o, twin.hi());
    pin("opcode_o", rtl->opcode_o, twin.opcode());
    if (!filled) return;
    rtl->word_addr_i = (rtl->word_addr_i + 1) % 7 & 7;
    rtl.eval();
    pin("word_o", rtl->word_o, twin.words()[rtl->word_addr_i]);
  }

  // LTRJ with all its seven words.
  void fill(unsigned word) {
    write(false, 0x1F);
    clocks(1000);
    for (int n = 0; n < 7; ++n) {
      const unsigned bits = n == 0 ? word | 0x2A : word;
      write(true, static_cast<std::uint8_t>(bits >> 8));
      write(true, static_cast<std::uint8_t>(bits));
      clocks(1000);
    }
    filled = true;
  }

  void clocks(int n) {
    for (int i = 0; i < n; ++i) edge();
  }

  void write(bool ps, std::uint8_t value) {
    in.pins = {false, true, false, ps, value};
    clocks(5);
    in.pins.wr_n = true;
    clocks(6);
  }
  std::uint8_t read(bool ps) {
    in.pins = {false, false, true, ps, 0};
    clocks(9);
    const std::uint8_t value = rtl->d_o;
    in.pins.rd_n = true;
    clocks(6);
    return value;
  }
};

}  // namespace

TEST_CASE("lm628_port agrees with its twin on random pins, ends, leaps and resets") {
  Pair pair;
  for (const unsigned word : {0x0000U, 0xFFFFU, 0x0000U}) pair.fill(word);
  Random random(71);
  for (int i = 0; i < 60000; ++i) {
    In& in = pair.in;
    if (random() % 4 == 0) in.pins.wr_n = random() % 2 == 0;
    if (random() % 12 == 0) in.pins.rd_n = random() % 3 != 0;
    if (random() % 30 == 0) in.pins.cs_n = random() % 4 == 0;
    if (random() % 12 == 0) in.pins.ps = random() % 3 != 0;
    if (random() % 8 == 0) {
      in.pins.d = static_cast<std::uint8_t>(random() % (random() % 8 == 0 ? 256 : 34));
    }
    if (random() % 200 == 0) in.ready = random() % 8 != 0;
    if (random() % 50 == 0) in.open = random() % 3 != 0;
    in.commit = random() % 60 == 0;
    in.sample = {static_cast<std::uint8_t>(random() & random() & random() & 0x7E),
                 random() % 2 == 0};
    in.command = {static_cast<std::uint8_t>(random() & random() & 0x7E), random() % 2 == 0};
    in.reply = random();
    if (random() % 3000 == 0) pair.reset();
    pair.edge();
    if (random() % 12 != 0) continue;
    in.commit = false;  // a pause
    for (int k = 0; k < 8; ++k) pair.edge(random() % 1000);
  }
}

TEST_CASE("lm628_port shows busy alone in the reset routine after RESET, 0 after the pin") {
  Pair pair;
  pair.write(false, 0x00);
  pair.in.ready = false;
  REQUIRE(pair.read(false) == 0x01);
  pair.reset();
  REQUIRE(pair.read(false) == 0x00);
}

TEST_CASE("lm628_port is busy for 1000 clocks after a byte of command and after each word") {
  Pair pair;
  pair.in.open = true;
  pair.write(false, 0x1C);  // MSKI
  int busy = 6 - 2;         // clocks since the edge that took it
  for (; (pair.read(false) & 1) != 0; busy += 15) {
  }
  REQUIRE(busy >= 1000 - 15);
  REQUIRE(busy <= 1000 + 30);
  pair.write(true, 0x00);
  REQUIRE((pair.read(false) & 1) == 0);  // a byte is not a word
  pair.write(true, 0x40);
  REQUIRE((pair.read(false) & 1) == 1);
}

// Data sheet, RDSTAT: "may be executed at any time".
TEST_CASE("lm628_port keeps the first byte of a word over status reads, of a reply too") {
  Pair pair;
  pair.write(false, 0x1D);  // RSTI
  pair.clocks(1000);
  pair.write(true, 0xFF);
  for (int n = 0; n < 3; ++n) REQUIRE(pair.read(false) == 0x84);
  pair.write(true, 0x00);
  pair.clocks(1000);
  REQUIRE(pair.read(false) == 0x80);
  pair.write(false, 0x0B);  // RDRV
  pair.clocks(1000);
  pair.in.reply = 0x1234;
  REQUIRE(pair.read(true) == 0x12);
  for (int n = 0; n < 3; ++n) REQUIRE(pair.read(false) == 0x80);
  REQUIRE(pair.read(true) == 0x34);
  REQUIRE((pair.read(false) & 3) == 1);
}

TEST_CASE("lm628_port drops the first byte of a word at a command, not its second as the next") {
  Pair pair;
  pair.write(false, 0x1D);
  pair.clocks(1000);
  pair.write(true, 0x12);
  pair.write(false, 0x1C);  // MSKI
  pair.clocks(1000);
  REQUIRE((pair.read(false) & 2) == 2);
  pair.write(true, 0x00);
  REQUIRE((pair.read(false) & 1) == 0);
  pair.write(true, 0x40);
  REQUIRE((pair.read(false) & 1) == 1);
}

TEST_CASE("lm628_port raises the interrupt for unmasked events, again where the bit is set") {
  Pair pair;
  const auto sample = [&](unsigned events) {
    pair.in.sample.events = static_cast<std::uint8_t>(events);
    pair.in.commit = true;
    pair.edge();
    pair.in.commit = false;
    pair.in.sample.events = 0;
    pair.edge();
  };
  sample(1u << trammel::exact::kBreakpoint);  // masked by the reset
  REQUIRE_FALSE(pair.rtl->hi_o);
  sample(1u << trammel::exact::kPositionError);
  REQUIRE(pair.rtl->hi_o);
  pair.write(false, 0x1D);  // RSTI: all bits stay, the interrupt goes
  pair.clocks(1000);
  pair.write(true, 0xFF);
  pair.write(true, 0xFF);
  pair.clocks(1000);
  REQUIRE_FALSE(pair.rtl->hi_o);
  REQUIRE((pair.read(false) & 0x60) == 0x60);
  sample(1u << trammel::exact::kPositionError);
  REQUIRE(pair.rtl->hi_o);
}
