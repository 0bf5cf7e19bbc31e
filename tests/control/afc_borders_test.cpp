// SPDX-License-Identifier: Apache-2.0
//
// Values at the limits of words, which random samples seldom reach.
#include <catch2/catch.hpp>
#include <random>

#include "tests/control/afc_bench.hpp"

using trammel::exact::Afc;
using Bench = trammel::test::AfcBench;

TEST_CASE("i_q* is clipped and marked just beyond its word, whatever the power of two") {
  // At rest rule 24 alone makes u; with Kp = 1 and Ki = 0 it is v*, and i_q* = rs(kv v*, 11 - s).
  Bench bench;
  bench.config.adapt = false;
  bench.config.kp = {1024, 1};
  bench.config.ki = {0, 0};
  std::mt19937 random(5);
  int marked = 0;
  for (int bit = 10; bit <= 26; ++bit) {
    for (int n = 0; n < 40; ++n) {
      // The result lies within a word around +-2^bit.
      const std::int64_t border = std::int64_t{1} << bit;
      const int exp = bit > 11 ? 15 : 1;
      std::int32_t mant = 0, v = 0;
      for (int tries = 0; tries < 100000; ++tries) {
        mant = static_cast<std::int32_t>(random() % 2048);
        v = static_cast<std::int32_t>(random() % 4096) - 2048;
        const std::int64_t result = trammel::fixed::rs(std::int64_t{mant} * v, 11 - exp);
        if (std::abs(std::abs(result) - border) < (n % 2 == 0 ? 64 : 2048)) break;
      }
      bench.config.kv = {mant, exp};
      bench.write(24, v * 4096);
      const Afc::Out out = bench.sample({0, 0});
      REQUIRE(out.v_star == v);
      marked += out.saturated;
    }
  }
  REQUIRE(marked > 300);
}

TEST_CASE("A start, a reset or a write is not quiescent, nor is a sample before its end") {
  Bench bench;
  bench.read(0);
  REQUIRE(bench.rtl->quiescent_o);
  for (auto* const pin : {&bench.rtl->start_i, &bench.rtl->reset_model_i, &bench.rtl->reset_table_i,
                          &bench.rtl->rule_we_i}) {
    *pin = 1;
    bench.rtl.eval();
    REQUIRE_FALSE(bench.rtl->quiescent_o);
    *pin = 0;
    bench.rtl.eval();
    REQUIRE(bench.rtl->quiescent_o);
  }
  bench.start({5, 0});
  for (int clock = 0; clock < trammel::test::kAfcClocks; ++clock) {
    REQUIRE_FALSE(bench.rtl->quiescent_o);
    bench.rtl.tick();
  }
  REQUIRE(bench.rtl->done_o);
  REQUIRE_FALSE(bench.rtl->quiescent_o);
  bench.rtl.tick();
  REQUIRE(bench.rtl->quiescent_o);
}
