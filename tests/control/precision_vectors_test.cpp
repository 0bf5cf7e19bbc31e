// SPDX-License-Identifier: Apache-2.0
//
// The check vectors of the precision controller (docs/precision.md, section 8) in RTL and twin.

#include <algorithm>
#include <array>

#include "tests/control/precision_bench.hpp"

using namespace trammel;
using test::Precision;
using test::PrecisionBench;
using test::Word;

namespace {

using Bench = PrecisionBench;

constexpr int kP = 35, kV = 36, kA = 37, kJ = 38, kU1 = 42, kU2 = 43, kUm = 44, kAff = 51, kI8 = 58,
              kErrSum = 55, kIqSum = 56;

std::int32_t defaults() { return Bench::misc(6, 4, 15, 26, true); }

// Full gains, 2.5 kg and 20 N s/m unless others are given.
void load(Bench& bench, std::int32_t fc, std::int32_t km = Bench::gain(1068, -3),
          std::int32_t kmi = Bench::gain(1964, 4), std::int32_t kb = Bench::gain(1094, -2)) {
  for (unsigned n = 0; n < 2; ++n) {
    bench.full_gains(n, defaults());
    bench.write(n, Word::kKm, km);
    bench.write(n, Word::kKmi, kmi);
    bench.write(n, Word::kKb, kb);
    bench.write(n, Word::kFc, fc);
    bench.write(n, Word::kC, 0);
    bench.write(n, Word::kIff, 0);
  }
}

void points(Bench& bench, std::int32_t c, std::int32_t iff = 0) {
  for (unsigned n = 0; n < 2; ++n) {
    bench.write(n, Word::kC, c);
    bench.write(n, Word::kIff, iff);
  }
  bench.commit();
}

void counts(Bench& bench, std::int64_t count) {
  bench.axis[0].count = bench.axis[1].count = static_cast<std::int32_t>(count);
}

// A word of both axes, in the RTL and the member of the twin's state.
template <class Member>
void require_word(Bench& bench, int word, Member member, std::int64_t value) {
  for (unsigned n = 0; n < 2; ++n) {
    CAPTURE(n, word);
    REQUIRE(bench.twin[n].state().*member == value);
    REQUIRE(bench.get(n, word) == value);
  }
}

using State = Precision::State;

void require_observer(Bench& bench, std::int64_t e1, std::int64_t e2, std::int64_t d) {
  require_word(bench, 16, &State::e1, e1);
  require_word(bench, 17, &State::e2, e2);
  require_word(bench, 18, &State::d, d);
}

struct Set {
  int word;
  std::int64_t State::*member;
  std::int64_t value;
};

void set(Bench& bench, std::initializer_list<Set> values) {
  for (const Set& one : values) {
    for (unsigned n = 0; n < 2; ++n) {
      bench.put(n, one.word, one.value);
      bench.twin[n].state().*one.member = one.value;
    }
  }
}

}  // namespace

TEST_CASE("The spline is that of the specification") {
  struct Row {
    int t;
    std::int64_t p, v, a;
  };
  constexpr std::array<Row, 8> kRows{{{32, 256, 256, 256},
                                      {33, 1024, 768, 512},
                                      {63, 1531904, 135168, 8192},
                                      {64, 1674752, 142848, 7680},
                                      {94, 6991872, 135168, -7680},
                                      {95, 7118848, 126976, -8192},
                                      {127, 8388608, 0, 0},
                                      {160, 8388608, 0, 0}}};
  Bench bench;
  load(bench, 0);
  bench.start(0);
  for (int t = 0; t <= 160; ++t) {
    if (t > 0 && t % 32 == 0) points(bench, 256);
    bench.tick();
    for (const Row& row : kRows) {
      if (row.t != t) continue;
      CAPTURE(t);
      require_word(bench, kP, &State::p, row.p);
      require_word(bench, kV, &State::v, row.v);
      require_word(bench, kA, &State::a, row.a);
    }
  }
}

TEST_CASE("The position between the counts is that of the specification") {
  struct Row {
    std::int64_t v24;
    bool fresh;
    int age;
    bool up;
    int f;
  };
  constexpr std::array<Row, 9> kRows{{{32768, true, 0, true, -102},
                                      {32768, true, 700, true, 13},
                                      {32768, true, 1500, true, 144},
                                      {32768, true, 3125, true, 154},
                                      {-32768, true, 700, false, -13},
                                      {-32768, true, 700, true, 0},
                                      {1000, true, 3125, true, -86},
                                      {102400, true, 200, true, 0},
                                      {32768, false, 700, true, 0}}};
  Bench bench;
  load(bench, 0);
  bench.start(1000);
  for (const Row& row : kRows) {
    CAPTURE(row.v24, row.age, row.up);
    set(bench, {{kV, &State::v, 512 * row.v24}, {kA, &State::a, 0}, {kJ, &State::j, 0}});
    for (auto& axis : bench.axis) {
      axis.ticks = row.fresh ? 14 : 15;
      axis.age = row.age;
      axis.up = row.up;
    }
    bench.pos = false;
    bench.tick();
    require_word(bench, 22, &State::y, 256000 + row.f);
  }
}

TEST_CASE("Single ticks are those of the specification") {
  struct Row {
    std::array<std::int64_t, 3> observer, acted;  // e1 e2 d, um u1 u2
    int count;
    std::int64_t a, j, e, acc, aff, vff, i8;
    int i_q;
    std::int64_t used;
    std::array<std::int64_t, 3> after;
    std::int64_t um;
  };
  const std::array<Row, 7> rows{{
      {{0, 0, 0}, {0, 0, 0}, 1000, 0, 0, 0, 0, 0, 16384, 6289, 25, 0, {0, 0, 0}, 0},
      {{0, 0, 0}, {0, 0, 0}, 999, 0, 0, 256, 191885, 0, 16384, 18797, 73, 191885,
       {1913, 61491, 81088}, 0},
      {{4096, 0, 0}, {0, 0, 0}, 1000, 0, 0, 0, -168284, 0, 16384, -4681, -18, -168284,
       {2183, -61491, -81088}, 0},
      {{0, 20000, -5000}, {1000, 2000, 3000}, 1000, 0, 0, 0, 28594, 0, 16384, 8153, 32, 28594,
       {78, 19898, -5000}, 1500},
      {{-9000, -3000, 12345}, {-777, 555, -333}, 1003, 5000, 30, -768, -198582, 41440, 16443, -3946,
       -15, -198582, {-10547, -52158, -52747}, -666},
      {{100, 50, 60}, {70, 80, 90}, 800, -40000, -100, 51200, 8388607, -324800, 15915, 531870, 2047,
       8268343, {367427, 8388607, 8388607}, 75},
      {{0, 0, 0}, {0, 0, 0}, -5000, 0, 0, 524287, 8388607, 0, 16384, 553105, 2047, 7942518,
       {3459065, 8388607, 8388607}, 0},
  }};
  Bench bench;
  load(bench, 4101);
  bench.start(0);
  bench.tick();  // a knot takes the words
  bench.pos = false;
  const std::int64_t speed = std::int64_t{1} << 23;
  for (const Row& row : rows) {
    CAPTURE(row.count, row.e);
    const std::int64_t v = speed - row.a;
    set(bench, {{16, &State::e1, row.observer[0]},
                {17, &State::e2, row.observer[1]},
                {18, &State::d, row.observer[2]},
                {kUm, &State::um, row.acted[0]},
                {kU1, &State::u1, row.acted[1]},
                {kU2, &State::u2, row.acted[2]},
                {kP, &State::p, 1000 * speed - speed},
                {kV, &State::v, v},
                {kA, &State::a, row.a - row.j},
                {kJ, &State::j, row.j}});
    counts(bench, row.count);
    bench.tick();
    require_word(bench, 54, &State::e, row.e);
    require_word(bench, 19, &State::acc, row.acc);
    require_word(bench, kAff, &State::aff, row.aff);
    require_word(bench, 20, &State::vff, row.vff);
    require_word(bench, kI8, &State::i8, row.i8);
    require_word(bench, kU1, &State::used, row.used);
    require_observer(bench, row.after[0], row.after[1], row.after[2]);
    require_word(bench, kUm, &State::um, row.um);
    for (unsigned n = 0; n < 2; ++n) REQUIRE(bench.i_q_ref(n) == row.i_q);
  }
}

TEST_CASE("The sequence is that of the specification") {
  struct Row {
    int t;
    std::int64_t p, e, e1, e2, d, acc, iff, i8;
    int i_q;
    std::int64_t err_sum, iq_sum;
  };
  const std::array<Row, 7> rows{{
      {33, 1024, 512, 6816, 141169, 200106, 469451, 0, 31798, 124, 1024, 208},
      {64, 1675520, 1075, 15015, 65947, 205651, 402931, 0, 35624, 139, 1075, 139},
      {100, 14622720, 1726, 27781, 116379, 414726, 769052, 0, 62962, 246, 8449, 1077},
      {161, 83083264, 2792, 43025, 83923, 687470, 1077412, 160, 83484, 326, 5534, 613},
      {192, 141238272, 3286, 49642, 33404, 817142, 1164163, 2480, 91591, 358, 3286, 358},
      {300, 466821120, 4774, 77231, -42128, 1580135, 1969826, 0, 142090, 555, 63187, 7799},
      {400, 938680320, 6630, 104476, 3583, 2701175, 3322226, 0, 230674, 901, 109818, 14976},
  }};
  Bench bench;
  load(bench, 4101);
  bench.start(0);
  std::int64_t before = 0;
  for (int t = 0; t <= 400; ++t) {
    const int k = t / 32;
    if (t > 0 && t % 32 == 0) points(bench, 256 * k * k, k == 5 ? 2560 : 0);
    counts(bench, (before >> 23) - t / 16);
    bench.tick();
    before = bench.twin[0].state().p;
    for (const Row& row : rows) {
      if (row.t != t) continue;
      CAPTURE(t);
      require_word(bench, kP, &State::p, row.p);
      require_word(bench, 54, &State::e, row.e);
      require_observer(bench, row.e1, row.e2, row.d);
      require_word(bench, 19, &State::acc, row.acc);
      REQUIRE(fixed::rs(bench.twin[0].state().iacc, 5) == row.iff);
      require_word(bench, kI8, &State::i8, row.i8);
      require_word(bench, kErrSum, &State::err_sum, row.err_sum);
      require_word(bench, kIqSum, &State::iq_sum, row.iq_sum);
      for (unsigned n = 0; n < 2; ++n) REQUIRE(bench.i_q_ref(n) == row.i_q);
    }
  }
}

TEST_CASE("Saturation and the way back are those of the specification") {
  Bench bench;
  load(bench, 4101, Bench::gain(1335, 0), Bench::gain(1571, 1));
  bench.start(0);
  for (int t = 0; t <= 39; ++t) {
    CAPTURE(t);
    counts(bench, t < 20 ? -600 : 0);
    if (t == 32) points(bench, 0);
    bench.tick();
    if (t == 0) {
      require_word(bench, 54, &State::e, 153600);
      require_word(bench, 19, &State::acc, 8388607);
      require_word(bench, kI8, &State::i8, 5468159);
      require_word(bench, kU1, &State::used, 803428);
      require_word(bench, 16, &State::e1, 1035732);
      REQUIRE(bench.out[0].saturated);
      REQUIRE(bench.i_q_ref(0) == 2047);
    }
    if (t == 1) require_word(bench, 16, &State::e1, 1648422);
    if (t == 19) {
      require_observer(bench, 2470152, 944889, -2049574);
      require_word(bench, kUm, &State::um, 798899);
    }
    if (t == 20) {
      require_word(bench, 54, &State::e, 0);
      REQUIRE(bench.i_q_ref(0) == -2048);
      require_word(bench, kU1, &State::used, -803820);
      require_word(bench, 16, &State::e1, 1428457);
    }
    if (t == 39) {
      require_word(bench, 19, &State::acc, 322240);
      REQUIRE(bench.i_q_ref(0) == 821);
      require_observer(bench, -14664, -949878, 2055669);
    }
  }
}

TEST_CASE("The current goes on where it was when the mass changes") {
  Bench bench;
  load(bench, 4101, Bench::gain(1068, -1), Bench::gain(1963, 2));
  for (unsigned n = 0; n < 2; ++n) bench.write(n, Word::kRatio, -6551);
  bench.start(0);
  set(bench, {{18, &State::d, 100000}, {kA, &State::a, 50000}});
  bench.tick();
  require_word(bench, 18, &State::d, 674);
  require_word(bench, 19, &State::acc, 1540);
  require_word(bench, kAff, &State::aff, 400000);
  require_word(bench, kI8, &State::i8, 108890);
  for (unsigned n = 0; n < 2; ++n) REQUIRE(bench.read(n, 4) == 0);  // RATIO is taken once
}

TEST_CASE("The acceleration ahead takes the jerk as 18 bits") {
  constexpr std::int64_t kEnd = 1 << 17;
  for (const std::int64_t j : {kEnd - 1, kEnd, 2 * kEnd - 1, 2 * kEnd, -kEnd, -kEnd - 1}) {
    CAPTURE(j);
    Bench bench;
    load(bench, 0);
    bench.start(0);
    bench.tick();
    set(bench, {{kA, &State::a, 0}, {kJ, &State::j, j}});
    bench.tick();  // LEAD is 6
    require_word(bench, kAff, &State::aff, 8 * (j + 6 * std::clamp(j, -kEnd, kEnd - 1)));
  }
}
