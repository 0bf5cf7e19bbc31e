// SPDX-License-Identifier: Apache-2.0
#include "models/exact/control/rule_store.hpp"

#include <Vrule_store.h>

#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "tests/support/rtl.hpp"

using trammel::exact::RuleStore;
using trammel::test::as_signed;

namespace {

template <class Port>
void set(Port& port, std::int64_t value, int bits) {
  port = static_cast<Port>(trammel::test::as_bits(value, bits));
}

struct Bench {
  trammel::test::Rtl<Vrule_store> rtl;
  RuleStore twin;

  Bench() {
    rtl->reset_i = 0;
    rtl->hold_i = 0;
    rtl->i_i = 0;
    rtl->j_i = 0;
    rtl->tune_we_i = 0;
    rtl->sel_i = 0;
    rtl->read_i = 0;
    rtl->tune_data_i = 0;
    rtl->addr_i = 0;
    rtl->we_i = 0;
    rtl->wdata_i = 0;
    rtl.reset();
    settle();
  }

  int settle() {
    int clocks = 0;
    for (; rtl->busy_o && clocks < 100; ++clocks) rtl.tick();
    return clocks;
  }

  std::int64_t read(int index) {
    set(rtl->addr_i, index, 6);
    rtl.tick();
    if (!rtl->quiescent_o) rtl.tick();  // after a write
    return as_signed(rtl->rdata_o, 24);
  }

  void write(int index, std::int32_t value) {
    set(rtl->addr_i, index, 6);
    set(rtl->wdata_i, value, 24);
    rtl->we_i = 1;
    rtl.tick();
    rtl->we_i = 0;
    rtl.eval();
  }

  void require_same() {
    for (int n = 0; n < 64; ++n) {
      CAPTURE(n);
      REQUIRE(read(n) == twin.read(n));
    }
  }

  void require_same_fired(int i, int j) {
    CAPTURE(i, j);
    set(rtl->i_i, i, 3);
    set(rtl->j_i, j, 3);
    const std::array<int, 4> fired = RuleStore::fired(i, j);
    for (unsigned which = 0; which < 4; ++which) {
      CAPTURE(which);
      set(rtl->sel_i, which, 2);
      rtl->read_i = 1;
      rtl.tick();
      rtl->read_i = 0;
      set(rtl->sel_i, which + 1, 2);  // what was read stays
      rtl.tick();
      REQUIRE(as_signed(rtl->rule_o, 24) == twin.read(fired[which]));
    }
  }
};

}  // namespace

// Kung eq. 19
TEST_CASE("The table after reset is that of the specification") {
  constexpr int kUnits[7][7] = {{-6, -6, -6, -6, -4, -2, 0}, {-6, -6, -6, -4, -2, 0, 2},
                                {-6, -6, -4, -2, 0, 2, 4},   {-6, -4, -2, 0, 2, 4, 6},
                                {-4, -2, 0, 2, 4, 6, 6},     {-2, 0, 2, 4, 6, 6, 6},
                                {0, 2, 4, 6, 6, 6, 6}};
  Bench bench;
  for (int n = 0; n < RuleStore::kRules; ++n) {
    CAPTURE(n);
    REQUIRE(bench.read(n) == kUnits[n / 7][n % 7] * 1048576);
    REQUIRE(bench.twin.read(n) == kUnits[n / 7][n % 7] * 1048576);
  }
}

TEST_CASE("The four fired rules are read in every section") {
  Bench bench;
  std::mt19937 random(1);
  for (int n = 0; n < RuleStore::kRules; ++n) {
    const auto value = static_cast<std::int32_t>(random() & 0xffffff) - 0x800000;
    bench.write(n, value);
    bench.twin.write(n, value);
  }
  bench.require_same();
  for (int j = 0; j < 6; ++j) {
    for (int i = 0; i < 6; ++i) bench.require_same_fired(i, j);
  }
}

TEST_CASE("Tuning and outside writes agree with the twin") {
  Bench bench;
  std::mt19937 random(2);
  for (int n = 0; n < 2000; ++n) {
    const auto value = static_cast<std::int32_t>(random() & 0xffffff) - 0x800000;
    if (random() % 2 == 0) {
      const int i = static_cast<int>(random() % 6);
      const int j = static_cast<int>(random() % 6);
      const unsigned which = random() % 4;
      set(bench.rtl->i_i, i, 3);
      set(bench.rtl->j_i, j, 3);
      set(bench.rtl->sel_i, which, 2);
      set(bench.rtl->tune_data_i, value, 24);
      bench.rtl->tune_we_i = 1;
      bench.rtl.eval();
      REQUIRE(!bench.rtl->quiescent_o);
      bench.rtl.tick();
      bench.rtl->tune_we_i = 0;
      bench.twin.write(RuleStore::fired(i, j)[which], value);
    } else {
      const int index = static_cast<int>(random() % 64);  // those above 48 do nothing
      bench.write(index, value);
      bench.twin.write(index, value);
    }
    bench.require_same_fired(static_cast<int>(random() % 6), static_cast<int>(random() % 6));
  }
  bench.require_same();
}

TEST_CASE("A table reset takes 49 writes, waits for the controller and shuts out other writes") {
  Bench bench;
  for (int n = 0; n < RuleStore::kRules; ++n) bench.write(n, 1000 + n);
  bench.rtl->hold_i = 1;
  bench.write(0, 7);
  REQUIRE(bench.read(0) == 1000);
  bench.rtl->reset_i = 1;
  bench.rtl.tick();
  bench.rtl->reset_i = 0;
  for (int n = 0; n < 100; ++n) bench.rtl.tick();
  REQUIRE(bench.rtl->busy_o);
  REQUIRE(bench.read(0) == 1000);
  bench.write(0, 7);
  REQUIRE(bench.read(0) == 1000);
  bench.rtl->hold_i = 0;
  bench.rtl.tick();
  int clocks = 0;
  for (; bench.rtl->busy_o; ++clocks) {
    REQUIRE(!bench.rtl->quiescent_o);
    bench.write(0, 7);
  }
  REQUIRE(clocks == RuleStore::kRules);
  REQUIRE(!bench.rtl->quiescent_o);  // the outside reads its rule anew
  bench.rtl.tick();
  REQUIRE(bench.rtl->quiescent_o);
  bench.require_same();
}

TEST_CASE("Reads, writes and resets in any clock keep their latencies, as quiescent_o shows") {
  Bench bench;
  auto& rtl = bench.rtl;
  std::mt19937 random(3);
  const auto one_in = [&](unsigned n) { return random() % n == 0; };
  int waits = 0, fills = 0;  // the table reset: 1 clock in which hold_i is low, then 49
  bool written = true;       // by the edge before
  int read_at = -1;          // the index of an edge without a write
  std::int64_t rule = 0;
  bool rule_known = false;
  for (int n = 0; n < 30000; ++n) {
    CAPTURE(n);
    const bool busy = waits + fills > 0;
    const bool reset = one_in(500), we = one_in(6), tune = !busy && one_in(8), read = one_in(4);
    if (one_in(busy ? 100 : 20)) rtl->hold_i = !rtl->hold_i;
    if (one_in(3)) {  // the next index differs in any of its bits
      set(rtl->addr_i, one_in(2) ? random() % 64 : rtl->addr_i ^ (1u << random() % 6), 6);
    }
    const int index = rtl->addr_i, i = static_cast<int>(random() % 6),
              j = static_cast<int>(random() % 6);
    const unsigned which = random() % 4;
    const auto fired = RuleStore::fired(i, j)[which];
    const auto value = static_cast<std::int32_t>(random() & 0xffffff) - 0x800000;
    rtl->reset_i = reset;
    rtl->we_i = we;
    rtl->tune_we_i = tune;
    set(rtl->i_i, i, 3);
    set(rtl->j_i, j, 3);
    set(rtl->sel_i, which, 2);
    set(rtl->wdata_i, value, 24);
    set(rtl->tune_data_i, value, 24);
    const bool writes_outside = we && !rtl->hold_i && !busy && !tune && index < 49;
    // The two reads never meet a write to their rule.
    rtl->read_i = read && !tune && !(writes_outside && index == fired) && fills == 0;
    rtl.eval();
    const bool settled = !written && index == read_at;
    REQUIRE(bool(rtl->busy_o) == busy);
    REQUIRE(bool(rtl->quiescent_o) ==
            (!busy && !reset && !rtl->read_i && !tune && !we && settled));
    if (settled) REQUIRE(as_signed(rtl->rdata_o, 24) == bench.twin.read(index));
    if (rule_known) REQUIRE(as_signed(rtl->rule_o, 24) == rule);
    if (rtl->read_i) {
      rule = bench.twin.read(fired);
      rule_known = true;
    }
    written = tune || writes_outside || fills > 0;
    if (!written) read_at = index;
    if (tune) bench.twin.write(fired, value);
    if (writes_outside) bench.twin.write(index, value);
    if (fills > 0) {
      if (--fills == 0) bench.twin.reset();
    } else if (waits > 0 && !rtl->hold_i) {
      waits = 0;
      fills = RuleStore::kRules;
    } else if (!busy && reset) {
      waits = 1;
    }
    rtl.tick();
  }
}
