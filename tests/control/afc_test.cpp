// SPDX-License-Identifier: Apache-2.0
#include "models/exact/control/afc.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "models/ideal/fuzzy_controller.hpp"
#include "tests/control/afc_bench.hpp"

using trammel::exact::Afc;
using trammel::exact::RuleStore;
using trammel::test::as_signed;
using Bench = trammel::test::AfcBench;

namespace {

constexpr int kClocks = trammel::test::kAfcClocks;

std::int32_t draw(std::mt19937& random, int bits) {
  const std::int64_t value = random() & ((std::uint64_t{1} << bits) - 1);
  return static_cast<std::int32_t>(as_signed(static_cast<std::uint64_t>(value), bits));
}

}  // namespace

// Kung eq. 24
TEST_CASE("The reference model gives the check vector, on the twin and in hardware") {
  struct Vector {
    int k;
    std::int32_t x_m, dx;
  };
  const std::vector<Vector> vectors{
      {0, 1816, 1816},        {1, 9025, 7209},        {2, 23282, 14257},
      {3, 44376, 21094},      {9, 303263, 57934},     {99, 14406589, 165330},
      {258, 29459360, 39677}, {259, 29498597, 39237}, {260, 29537399, 38802},
      {399, 32195962, 7401},  {749, 32762875, 73}};
  Bench bench;
  std::size_t next = 0;
  for (int k = 0; k <= 749; ++k) {
    const Afc::Out out = bench.sample({2000, 0});
    if (k >= 717) REQUIRE(out.x_r == 2000);
    if (vectors[next].k != k) continue;
    CAPTURE(k);
    REQUIRE(out.x_m == vectors[next].x_m);
    REQUIRE(out.dx == vectors[next].dx);
    ++next;
  }
  REQUIRE(next == vectors.size());
}

// Kung eq. 15 to 20
TEST_CASE("The fuzzy controller gives the check vectors, on the twin and in hardware") {
  struct Vector {
    std::int32_t e, de;
    int i, j;
    std::array<std::int32_t, 4> d;
    std::int32_t u, v_star, i_q_ref;
  };
  const std::vector<Vector> vectors{{0, 0, 3, 3, {2048, 0, 0, 0}, 0, 0, 0},
                                    {1, 0, 3, 3, {2044, 4, 0, 0}, 1, 0, 0},
                                    {-1, 0, 2, 3, {4, 2044, 0, 0}, -1, 0, 0},
                                    {3, -2, 3, 2, {32, 0, 2004, 12}, -5, -2, -4},
                                    {256, 0, 3, 3, {1024, 1024, 0, 0}, 256, 97, 178},
                                    {-256, 0, 2, 3, {1024, 1024, 0, 0}, -256, -97, -178},
                                    {512, 64, 4, 3, {1024, 0, 1024, 0}, 768, 290, 534},
                                    {511, 63, 3, 3, {2, 1038, 2, 1006}, 763, 288, 530},
                                    {1000, 200, 4, 4, {42, 854, 54, 1098}, 1526, 577, 1062},
                                    {-700, 30, 1, 3, {576, 992, 176, 304}, -580, -219, -403},
                                    {2047, 0, 5, 3, {4, 2044, 0, 0}, 1535, 581, 1069},
                                    {-2048, 0, 0, 3, {2048, 0, 0, 0}, -1536, -581, -1069}};
  for (const Vector& vector : vectors) {
    CAPTURE(vector.e, vector.de);
    Bench bench;
    // v = 0 and de != 0 mean that the model moves while the table stands. A far command clips s, so
    // that A0 = 1024 de and B2 = 1 let dx grow by de / 32 per sample; x_p takes its place for the
    // last two samples.
    constexpr std::int32_t kRest = 50000;
    constexpr int kRun = 32;
    const std::int32_t command = vector.de < 0 ? -8000000 : 8000000;
    const auto x_r = kRest + static_cast<std::int32_t>(std::floor(vector.de * 16.5 + 0.5));
    bench.reset(kRest);
    const Afc::Config defaults;
    bench.config.kp.mant = bench.config.ki.mant = bench.config.eta.mant = 0;
    bench.config.a0 = 1024 * std::abs(vector.de);
    bench.config.b2 = 8388607;
    for (int k = 1; k < kRun; ++k) {
      bench.sample({command, k == kRun - 1 ? x_r - vector.e : kRest});
    }
    bench.config.kp = defaults.kp;
    bench.config.ki = defaults.ki;
    const Afc::Out out = bench.sample({command, x_r - vector.e});
    REQUIRE(out.e == vector.e);
    REQUIRE(out.de == vector.de);
    REQUIRE(out.v == 0);
    REQUIRE(out.i == vector.i);
    REQUIRE(out.j == vector.j);
    REQUIRE(out.d == vector.d);
    REQUIRE(out.u == vector.u);
    REQUIRE(out.v_star == vector.v_star);
    REQUIRE(out.i_q_ref == vector.i_q_ref);
  }
}

// Kung eq. 27
TEST_CASE("Learning gives the sequence vector, on the twin and in hardware") {
  struct Vector {
    int k;
    std::int32_t x_r, e, de, u, v_star, i_q_ref, v, c33, c34;
  };
  const std::vector<Vector> vectors{{1, 1, 1, 1, 5, 2, 4, 0, 9, 2097152},
                                    {3, 3, 3, 2, 11, 4, 7, 0, 44, 2097152},
                                    {7, 12, 12, 3, 24, 9, 17, 0, 310, 2097156},
                                    {15, 46, 42, 4, 58, 23, 13, 16, 2087, 2097267},
                                    {31, 164, 145, 8, 178, 74, 107, 16, 12172, 2099812},
                                    {39, 239, 209, 8, 244, 105, 134, 32, 19934, 2104112}};
  Bench bench;
  std::size_t next = 0;
  for (int k = 0; k <= 39; ++k) {
    const Afc::Out out = bench.sample({2000, k * k / 50});
    if (vectors[next].k != k) continue;
    CAPTURE(k);
    const Vector& vector = vectors[next++];
    REQUIRE(out.x_r == vector.x_r);
    REQUIRE(out.e == vector.e);
    REQUIRE(out.de == vector.de);
    REQUIRE(out.u == vector.u);
    REQUIRE(out.v_star == vector.v_star);
    REQUIRE(out.i_q_ref == vector.i_q_ref);
    REQUIRE(out.v == vector.v);
    REQUIRE(bench.twin.rule(24) == vector.c33);
    REQUIRE(bench.twin.rule(25) == vector.c34);
    REQUIRE(bench.read(24) == vector.c33);
    REQUIRE(bench.read(25) == vector.c34);
  }
  REQUIRE(next == vectors.size());
}

TEST_CASE("A sample is 35 steps of two clocks and publishes i_q* at the end of s29") {
  Bench bench;
  bench.sample({2000, 0});
  const auto before = bench.rtl->i_q_ref_o;
  bench.start({8000000, -1000});
  for (int clock = 0; clock < kClocks; ++clock) {
    CAPTURE(clock);
    REQUIRE(bench.rtl->busy_o);
    REQUIRE(bench.rtl->step_o == clock / 2);
    REQUIRE(!bench.rtl->done_o);
    REQUIRE(!bench.rtl->quiescent_o);
    REQUIRE(static_cast<bool>(bench.rtl->iq_valid_o) == (clock == 60));
    REQUIRE((bench.rtl->i_q_ref_o == before) == (clock < 60));
    bench.rtl.tick();
  }
  REQUIRE(!bench.rtl->busy_o);
  REQUIRE(bench.rtl->done_o);
  bench.rtl.tick();
  REQUIRE(!bench.rtl->done_o);
  REQUIRE(bench.rtl->quiescent_o);
  bench.require_same(bench.twin.step(bench.config, {8000000, -1000}));
}

TEST_CASE("A start while busy raises overrun and is ignored") {
  Bench bench;
  for (int late = 0; late < kClocks; ++late) {
    CAPTURE(late);
    const Afc::In in{2000 + late, late};
    bench.start(in);
    for (int clock = 0; clock < late; ++clock) bench.rtl.tick();
    REQUIRE(!bench.rtl->overrun_o);
    bench.rtl->start_i = 1;
    bench.rtl.eval();
    REQUIRE(bench.rtl->overrun_o);
    bench.rtl.tick();
    bench.rtl->start_i = 0;
    bench.rtl.eval();
    REQUIRE(!bench.rtl->overrun_o);
    REQUIRE(bench.settle() == kClocks - late - 1);
    bench.require_same(bench.twin.step(bench.config, in));
  }
}

TEST_CASE("Exactly the four fired rules change, with the sign of the error") {
  Bench bench;
  std::mt19937 random(5);
  bench.config.eta = {2047, -6};
  for (int n = 0; n < 200; ++n) {
    std::array<std::int64_t, 49> before{};
    for (int index = 0; index < 49; ++index) {
      before[static_cast<std::size_t>(index)] = bench.read(index);
    }
    bench.config.adapt = n % 4 != 0;
    const std::int32_t x_p = draw(random, 11);
    const Afc::Out out = bench.sample({x_p, x_p});
    const std::array<int, 4> fired = RuleStore::fired(out.i, out.j);
    for (int index = 0; index < 49; ++index) {
      CAPTURE(n, index);
      const std::int64_t change = bench.read(index) - before[static_cast<std::size_t>(index)];
      std::int64_t weight = 0;
      for (std::size_t which = 0; which < 4; ++which) {
        if (fired[which] == index) weight = out.d[which];
      }
      if (!bench.config.adapt || weight == 0) REQUIRE(change == 0);
      REQUIRE(change * out.e >= 0);
      if (bench.config.adapt && weight * std::abs(out.e) > 64) REQUIRE(change != 0);
    }
  }
}

TEST_CASE("A start with reset_model is bumpless and leaves the rules") {
  Bench bench;
  for (int k = 0; k < 40; ++k) bench.sample({2000, k * k / 50});
  const std::int64_t learned = bench.read(25);
  bench.reset(30000);
  REQUIRE(as_signed(bench.rtl->x_r_o, 24) == 30000);
  REQUIRE(bench.rtl->dx_o == 0);
  REQUIRE(bench.rtl->e_o == 0);
  REQUIRE(bench.rtl->v_o == 0);
  REQUIRE(bench.read(25) == learned);
  const Afc::Out next = bench.sample({30000, 30000});
  REQUIRE(next.e == 0);
  REQUIRE(next.v == 0);
  REQUIRE(std::abs(next.i_q_ref) <= 4);  // c[3][3] has learned 4 parts of 1/256 unit
}

TEST_CASE("A pulse of reset_model between samples acts on the next sample only") {
  Bench bench;
  bench.sample({2000, 10});
  bench.rtl->reset_model_i = 1;
  bench.rtl.tick();
  bench.rtl->reset_model_i = 0;
  bench.rtl.tick();
  REQUIRE(bench.rtl->quiescent_o);
  bench.twin.reset(500);
  bench.start({2000, 500});
  REQUIRE(bench.settle() == kClocks);
  bench.require_same(bench.twin.step(bench.config, {500, 500}));
  bench.sample({2000, 500});
}

TEST_CASE("A table reset restores the 49 rules and a start waits for it") {
  Bench bench;
  for (int n = 0; n < 49; ++n) bench.write(n, 12345 * n);
  bench.require_same_rules();
  bench.rtl->reset_table_i = 1;
  bench.rtl.tick();
  bench.rtl->reset_table_i = 0;
  bench.rtl.eval();
  REQUIRE(bench.rtl->table_busy_o);
  bench.twin.reset_table();
  bench.start({700, 0});
  for (int late = 0; late < 60; ++late) {  // while it waits, then while it runs: another is lost
    CAPTURE(late);
    bench.rtl->start_i = 1;
    bench.rtl.eval();
    REQUIRE(bench.rtl->overrun_o);
    bench.rtl->start_i = 0;
    bench.rtl.tick();
  }
  REQUIRE(bench.settle() > 0);
  bench.require_same(bench.twin.step(bench.config, {700, 0}));
  bench.require_same_rules();
}

TEST_CASE("A table reset requested during a sample acts after it") {
  Bench bench;
  for (int n = 0; n < 49; ++n) bench.write(n, 12345 * n);
  bench.start({700, 0});
  bench.rtl->reset_table_i = 1;
  bench.rtl.tick();
  bench.rtl->reset_table_i = 0;
  bench.settle();
  bench.require_same(bench.twin.step(bench.config, {700, 0}));
  bench.twin.reset_table();
  bench.require_same_rules();
}

TEST_CASE("Rules can be written from outside between samples, not during one") {
  Bench bench;
  bench.write(24, -5000000);
  bench.sample({0, 0});
  bench.start({0, 0});
  const std::int32_t kept = bench.twin.rule(0);
  bench.write(0, 77);
  bench.twin.set_rule(0, kept);
  bench.settle();
  bench.require_same(bench.twin.step(bench.config, {0, 0}));
  bench.require_same_rules();
}

TEST_CASE("RTL and twin agree over random samples, gains and rules, at the edges too") {
  Bench bench;
  std::mt19937 random(4);
  std::int32_t x_p = 0;
  for (int n = 0; n < 6000; ++n) {
    CAPTURE(n);
    if (n % 50 == 0) {
      const auto gain = [&] {
        return trammel::fixed::Gain{static_cast<std::int32_t>(random() % 2048), draw(random, 5)};
      };
      const Afc::Config defaults;
      bench.config = defaults;
      if (n % 100 == 0) {
        bench.config.kp = gain();
        bench.config.ki = gain();
        bench.config.kv = gain();
        bench.config.eta = gain();
        bench.config.shift_e = draw(random, 5);
        bench.config.shift_de = draw(random, 5);
      }
      if (n % 400 == 0) {
        bench.config.a0 = static_cast<std::int32_t>(random() & 0x3ffff);
        bench.config.a0_scale = static_cast<int>(random() % 4);
        bench.config.b2 = draw(random, 24);
      }
      bench.config.feedforward = random() % 2 == 0;
      bench.config.adapt = random() % 4 != 0;
      bench.write(static_cast<int>(random() % 49), draw(random, 24));
      if (n % 150 == 0) bench.reset(draw(random, 24));
    }
    const bool far = random() % 20 == 0;
    const auto near = static_cast<std::int32_t>(as_signed(bench.rtl->x_r_o, 24));
    x_p = far ? draw(random, 24) : near + draw(random, 10);
    bench.sample({random() % 3 == 0 ? draw(random, 24) : x_p + draw(random, 12), x_p});
  }
  bench.require_same_rules();
}

TEST_CASE("In the linear area u is E + DE within one, and the weights sum to one") {
  Afc::Config config;
  config.adapt = false;
  std::mt19937 random(6);
  for (int n = 0; n < 20000; ++n) {
    Afc afc;
    // e_prev = 0 after a reset; the sample has de = e, so the shifts set the ratio. Those below 0
    // lose no bit of an error.
    config.shift_e = static_cast<int>(random() % 5) - 2;
    config.shift_de = static_cast<int>(random() % 5) - 2;
    const std::int32_t e = draw(random, 11);
    const Afc::Out out = afc.step(config, {0, -e});
    const double universe_e = std::ldexp(out.e, config.shift_e);
    const double universe_de = std::ldexp(out.de, config.shift_de);
    const std::int32_t sum = out.d[0] + out.d[1] + out.d[2] + out.d[3];
    REQUIRE(std::abs(sum - 2048) <= 2);
    const bool inside = std::abs(universe_e) < 1535 && std::abs(universe_de) < 1535;
    const int lowest = 2 * (out.i + out.j - 6);
    if (inside && lowest >= -6 && lowest + 4 <= 6) {
      REQUIRE(std::abs(out.u - universe_e - universe_de) <= 1);
    }
  }
}

TEST_CASE("Sample by sample the words stay near double precision") {
  // Same inputs to both. u: the floor of c costs below 1, the rounding of four d below 4 / 2 * 6
  // units / 2048 = 1.5, of u 0.5. Kp passes on 1.1 of these 3 and the integrator Ki 3 per sample,
  // less because u errs in both directions; Kv doubles it.
  Afc afc;
  trammel::ideal::FuzzyController ideal;
  for (int k = 0; k < 2000; ++k) {
    const auto x_p = static_cast<std::int32_t>(std::lround(1000 * (1 - std::cos(k * 0.005))));
    const std::int32_t r = k < 1000 ? 2000 : 0;
    const Afc::Out out = afc.step({}, {r, x_p});
    const auto expected = ideal.step({}, out.x_r, x_p);
    CAPTURE(k);
    REQUIRE(out.e == expected.e);
    REQUIRE(std::fabs(out.u - expected.u) < 3);
    REQUIRE(std::fabs(out.v_star - expected.v_star) < 4);
    REQUIRE(std::fabs(out.i_q_ref - expected.i_q_ref) < 8);
  }
}
