// SPDX-License-Identifier: Apache-2.0

#include "tests/control/precision_bench.hpp"
#include "tests/support/random.hpp"

using namespace trammel;
using test::Precision;
using test::PrecisionBench;
using test::Random;
using test::Word;

namespace {

std::int32_t random_word(Random& random) {
  const unsigned bits = random() % 33;
  return bits == 0 ? 0 : static_cast<std::int32_t>(test::as_signed(random(), 32)) >> (32 - bits);
}

std::int32_t random_gain(Random& random) {
  return PrecisionBench::gain(static_cast<int>(random() % 2048), static_cast<int>(random() % 32));
}

}  // namespace

TEST_CASE("precision agrees with its twin on random registers, knots, edges and counts") {
  PrecisionBench bench;
  Random random(1);
  const auto one_in = [&](unsigned n) { return random() % n == 0; };
  for (unsigned n = 0; n < 2; ++n) {
    bench.full_gains(n, PrecisionBench::misc(6, 4, 15, 26, true));
    bench.write(n, Word::kKm, PrecisionBench::gain(1068, -3));
    bench.write(n, Word::kKmi, PrecisionBench::gain(1964, 4));
    bench.write(n, Word::kKb, PrecisionBench::gain(1094, -2));
    bench.write(n, Word::kFc, 4101);
  }
  for (int t = 0; t < 6000; ++t) {
    CAPTURE(t);
    bench.pos = t % 8 == 0;
    for (unsigned n = 0; n < 2; ++n) {
      auto& axis = bench.axis[n];
      if (one_in(4)) axis.count += static_cast<std::int32_t>(random() % 9) - 4;
      if (one_in(900)) axis.count = static_cast<std::int32_t>(test::as_signed(random(), 24));
      axis.count = static_cast<std::int32_t>(fixed::wrap(axis.count, 24));
      axis.ticks = static_cast<int>(random() % (one_in(2) ? 2 : 16));
      axis.age = static_cast<std::int32_t>(random() % (one_in(2) ? 3200 : 50018));
      axis.up = one_in(2);
      if (one_in(axis.reset ? 3 : 150)) axis.reset = !axis.reset;
      if (one_in(axis.enable ? 400 : 3)) axis.enable = !axis.enable;
      bench.apply();
      while (one_in(3)) {
        const int word = static_cast<int>(random() % 32);
        if (word >= 8 && word <= 12) bench.write(n, word, random_gain(random));
        else if (word == 0) bench.write(n, word, 256 * axis.count + random_word(random) / 65536);
        else if (word == 2 || word == 3 || word == 5) bench.write(n, word, random_gain(random));
        else if (one_in(3)) bench.write(n, word, random_word(random));
      }
      if (one_in(60)) bench.full_gains(n, PrecisionBench::misc(6, 4, 15, 26, true));
    }
    bench.apply();
    if (one_in(t / 1000 % 2 == 0 ? 20 : 90)) bench.commit();
    if (!bench.axis[0].enable && !bench.axis[1].enable) continue;
    bench.tick(one_in(40));
    if (one_in(20)) bench.require_same_words();
  }
}

TEST_CASE("precision takes 229 clocks, 277 at a knot or in reset") {
  PrecisionBench bench;
  REQUIRE(bench.tick() == Precision::kKnotClocks);  // in reset
  REQUIRE(bench.tick() == Precision::kClocks);
  bench.commit();
  REQUIRE(bench.tick() == Precision::kKnotClocks);
  REQUIRE(bench.tick() == Precision::kClocks);
}

TEST_CASE("precision goes on at constant speed for two knots without a COMMIT, then stops") {
  PrecisionBench bench;
  bench.start(0);
  for (int c : {0, 1000, 3000}) {
    bench.write(0, Word::kC, c);
    bench.commit();
    for (int t = 0; t < 32; ++t) bench.tick();
  }
  const auto& state = bench.twin[0].state();
  int missed = 0;
  for (const int c : {5000, 7000, 7000, 7000}) {
    bench.tick();  // REQUIREs underrun_o
    REQUIRE(bench.knots.underrun());
    REQUIRE(state.c1 == c);
    REQUIRE(bench.get(0, 32) == c);
    for (int t = 1; t < 32; ++t) bench.tick();
    ++missed;
  }
  REQUIRE(missed == 4);
  bench.write(0, Word::kC, 8000);
  bench.commit();
  bench.tick();
  REQUIRE_FALSE(bench.knots.underrun());
  REQUIRE(bench.get(0, 32) == 8000);
}

TEST_CASE("Control points that coasting takes beyond 35 bits wrap in RTL and twin alike") {
  PrecisionBench bench;
  bench.start(0);
  const auto& state = bench.twin[0].state();
  constexpr std::int64_t kMost = 0x7FFFFFFF;
  std::int64_t highest = 0;
  for (const int sign : {1, -1, 0, 0, 1, 0, 0, 0, -1, 1}) {  // 0: no COMMIT
    CAPTURE(sign, highest);
    if (sign != 0) {
      bench.write(0, Word::kC, static_cast<std::int32_t>(sign * kMost));
      bench.commit();
    }
    bench.tick();
    REQUIRE(bench.get(0, 32) == state.c1);
    REQUIRE(bench.get(0, 38) == state.j);
    for (int t = 1; t < 32; ++t) bench.tick();
    REQUIRE(bench.get(0, 35) == state.p);
    if (state.c1 > highest) highest = state.c1;
  }
  REQUIRE(highest == 13 * kMost);
}

TEST_CASE("The first knot is at 2 kHz after a COMMIT, which a tick in its clock does not take") {
  PrecisionBench bench;
  bench.start(0);
  bench.pos = false;
  for (int t = 0; t < 5; ++t) bench.tick();
  REQUIRE(bench.read(0, 62) == 0);
  bench.pos = true;
  bench.tick();
  REQUIRE(bench.read(0, 62) == 1);
  for (int t = 1; t < 32; ++t) bench.tick();
  bench.tick(true);  // too late for this knot
  REQUIRE(bench.knots.underrun());
  REQUIRE(bench.read(0, 62) == 2);
  for (int t = 1; t < 32; ++t) bench.tick();
  bench.tick();
  REQUIRE_FALSE(bench.knots.underrun());
}

TEST_CASE("An axis in reset stands at its count with all else 0, whatever the other one does") {
  PrecisionBench bench;
  for (unsigned n = 0; n < 2; ++n) {
    bench.full_gains(n, PrecisionBench::misc(6, 4, 15, 26, true));
    bench.write(n, Word::kKm, PrecisionBench::gain(1068, -3));
    bench.write(n, Word::kC, 256 * 4000);
  }
  bench.start(3000);
  for (int t = 0; t < 40; ++t) {
    if (t == 30) bench.commit();
    bench.tick();
  }
  REQUIRE(bench.i_q_ref(0) != 0);
  bench.axis[0].reset = true;
  bench.axis[0].count = -1234;
  for (int t = 0; t < 3; ++t) bench.tick();
  REQUIRE(bench.i_q_ref(0) == 0);
  REQUIRE(bench.i_q_ref(1) != 0);
  for (int word = 16; word < 63; ++word) {
    CAPTURE(word);
    // The scratch words T1 and T2 are no state.
    const std::int64_t p = std::int64_t{-1234} * (1 << 23);
    if (word == 52 || word == 53) continue;
    REQUIRE(bench.get(0, word) == (word == 35 ? p : word >= 32 && word <= 34 ? -1234 * 256 : 0));
  }
}

TEST_CASE("A tick while the law runs is an overrun and changes nothing") {
  PrecisionBench bench;
  bench.apply();
  bench.rtl->tick_i = 1;
  bench.rtl.tick();
  for (int n = 1; n < Precision::kKnotClocks; ++n) {
    bench.rtl->tick_i = n % 100 == 20;
    bench.rtl.eval();
    REQUIRE(bool(bench.rtl->overrun_o) == (n % 100 == 20));
    bench.rtl.tick();
    REQUIRE_FALSE(bench.rtl->done_o);
  }
  bench.rtl->tick_i = 0;
  bench.rtl.tick();
  REQUIRE(bench.rtl->done_o);
}

TEST_CASE("A tick that no axis wants is no overrun, and a reset ends run and current") {
  PrecisionBench bench;
  bench.start(0);
  for (unsigned n = 0; n < 2; ++n) bench.write(n, Word::kIff, 256 * 100);
  for (int t = 0; t < 40; ++t) bench.tick();
  REQUIRE(bench.i_q_ref(0) != 0);
  REQUIRE(bench.i_q_ref(1) != 0);
  bench.rtl->tick_i = 1;
  bench.rtl.tick();
  bench.axis[0].enable = bench.axis[1].enable = false;
  bench.apply();
  REQUIRE(bench.rtl->busy_o);
  REQUIRE_FALSE(bench.rtl->overrun_o);
  bench.rtl->tick_i = 0;
  bench.rtl.reset();
  REQUIRE_FALSE(bench.rtl->busy_o);
  REQUIRE(bench.i_q_ref(0) == 0);
  REQUIRE(bench.i_q_ref(1) == 0);
}

TEST_CASE("precision is quiescent between its runs, with and without an axis enabled") {
  PrecisionBench bench;
  bench.start(0);
  for (int n = 0; n < 4; ++n) {
    bench.tick();
    bench.clock();
    REQUIRE(bench.rtl->quiescent_o);
    bench.rtl->commit_i = 1;
    bench.rtl.eval();
    REQUIRE_FALSE(bench.rtl->quiescent_o);
    bench.rtl->commit_i = 0;
    bench.rtl.eval();
  }
  bench.axis[0].reset = true;  // what an axis asks for is kept
  bench.apply();
  REQUIRE_FALSE(bench.rtl->quiescent_o);
  bench.clock();
  REQUIRE(bench.rtl->quiescent_o);
  bench.axis[0].enable = bench.axis[1].enable = false;
  bench.apply();
  bench.clock();
  REQUIRE(bench.rtl->quiescent_o);
  bench.rtl->tick_i = 1;
  bench.rtl.tick();
  bench.rtl->tick_i = 0;
  bench.rtl.eval();
  REQUIRE_FALSE(bench.rtl->busy_o);
}

TEST_CASE("precision is not quiescent where the law starts and nothing else moves") {
  PrecisionBench bench;
  for (int t = 0; t < 32; ++t) bench.tick();  // the count of ticks is 0 again
  bench.axis[0].reset = bench.axis[1].reset = true;
  bench.apply();
  bench.rtl->tick_i = 1;
  bench.rtl.eval();
  REQUIRE_FALSE(bench.rtl->quiescent_o);
}

TEST_CASE("precision is quiescent in no clock of a run") {
  PrecisionBench bench;
  bench.start(0);
  bench.rtl->tick_i = 1;
  bench.rtl.tick();
  bench.rtl->tick_i = 0;
  bench.rtl.eval();
  int clocks = 0;
  for (; bench.rtl->busy_o; ++clocks) {
    CAPTURE(clocks);
    REQUIRE_FALSE(bench.rtl->quiescent_o);
    bench.rtl.tick();
  }
  CHECK(clocks > 200);
}

TEST_CASE("The bus waits for the law and reads what it left") {
  PrecisionBench bench;
  bench.start(0);
  bench.apply();
  bench.rtl->tick_i = 1;
  bench.rtl.tick();
  bench.rtl->tick_i = 0;
  bench.rtl->request_i = 1;
  bench.rtl->request_addr_i = bench.address(1, 54);
  bench.rtl.tick();
  bench.rtl->request_i = 0;
  int clocks = 0;
  for (; !bench.rtl->ack_o; ++clocks) {
    bench.rtl.tick();
    REQUIRE(clocks < 320);
  }
  REQUIRE_FALSE(bench.rtl->busy_o);
  REQUIRE(clocks >= Precision::kClocks - 1);
}
