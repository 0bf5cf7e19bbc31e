// SPDX-License-Identifier: Apache-2.0
//
// The RTL of the precision controller beside its twins: registers, ticks and what the bus reads.
#pragma once

#include <Vprecision.h>
#include <Vprecision___024root.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>

#include "models/exact/control/precision.hpp"
#include "tests/support/rtl.hpp"

namespace trammel::test {

using exact::Precision;
using exact::PrecisionKnots;
using exact::PrecisionStore;
using Word = PrecisionStore::Word;

// The words in the RTL; in the flat netlist of its mutants they have the second name.
template <class Root>
auto words_of(Root& root, int) -> decltype((root.precision__DOT__u_store__DOT__mem_q)) {
  return root.precision__DOT__u_store__DOT__mem_q;
}
template <class Root>
auto words_of(Root& root, long) -> decltype((root.precision__DOT__u_store__02emem_q)) {
  return root.precision__DOT__u_store__02emem_q;
}

struct PrecisionBench {
  struct Axis {
    bool enable = true, reset = false;
    std::int32_t count = 0;
    int ticks = 15;
    std::int32_t age = 0;
    bool up = false;
  };

  Rtl<Vprecision> rtl;
  std::array<Precision, 2> twin;
  PrecisionStore window;
  PrecisionKnots knots;
  std::array<Axis, 2> axis;
  std::array<bool, 2> asked{true, true};  // for a reset
  std::array<Precision::Out, 2> out;
  bool pos = true;  // the next tick is one of 2 kHz

  PrecisionBench() {
    rtl->tick_i = rtl->tick_pos_i = rtl->commit_i = rtl->request_i = 0;
    rtl->request_we_i = 0;
    rtl->request_addr_i = 0;
    rtl->request_data_i = 0;
    apply();
    rtl.reset();
  }

  void apply() {
    unsigned enable = 0, reset = 0, up = 0, ticks = 0;
    std::uint64_t count = 0;
    std::uint32_t age = 0;
    for (unsigned n = 0; n < 2; ++n) {
      enable |= (axis[n].enable ? 1u : 0u) << n;
      reset |= (axis[n].reset ? 1u : 0u) << n;
      up |= (axis[n].up ? 1u : 0u) << n;
      ticks |= static_cast<unsigned>(axis[n].ticks) << (4 * n);
      age |= static_cast<std::uint32_t>(axis[n].age) << (16 * n);
      count |= static_cast<std::uint64_t>(as_bits(axis[n].count, 24)) << (24 * n);
    }
    rtl->enable_i = static_cast<std::uint8_t>(enable);
    rtl->reset_i = static_cast<std::uint8_t>(reset);
    rtl->up_i = static_cast<std::uint8_t>(up);
    rtl->ticks_i = static_cast<std::uint8_t>(ticks);
    rtl->age_i = age;
    rtl->count_i = count;
    rtl.eval();
  }

  // A stored word of the RTL, any of the 64 of an axis.
  auto& cell(unsigned n, int word) {
    return words_of(*rtl->rootp, 0)[64 * n + static_cast<unsigned>(word)];
  }
  std::int64_t get(unsigned n, int word) { return as_signed(cell(n, word), 48); }
  void put(unsigned n, int word, std::int64_t value) {
    cell(n, word) = static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << 48) - 1);
  }

  bool off(unsigned n) const { return !axis[n].enable || axis[n].reset; }
  PrecisionKnots::In edge(bool tick, bool commit) const {
    return {tick, tick && pos, commit, off(0) && off(1)};
  }

  // One clock without a tick.
  void clock(bool commit = false) {
    rtl->commit_i = commit;
    rtl.tick();
    rtl->commit_i = 0;
    knots.clock(edge(false, commit));
    for (unsigned n = 0; n < 2; ++n) asked[n] = asked[n] || off(n);
  }
  void commit() { clock(true); }

  std::uint8_t address(unsigned n, int word) const {
    return static_cast<std::uint8_t>(64 * n + static_cast<unsigned>(word));
  }

  void write(unsigned n, int word, std::int32_t value) {
    rtl->request_i = rtl->request_we_i = 1;
    rtl->request_addr_i = address(n, word);
    rtl->request_data_i = static_cast<std::uint32_t>(value);
    clock();
    rtl->request_i = 0;
    wait();
    window.write(static_cast<int>(n), word, value);
  }
  void write(unsigned n, Word word, std::int32_t value) {
    write(n, static_cast<int>(word), value);
  }
  std::int32_t read(unsigned n, int word) {
    rtl->request_i = 1;
    rtl->request_we_i = 0;
    rtl->request_addr_i = address(n, word);
    clock();
    rtl->request_i = 0;
    wait();
    return static_cast<std::int32_t>(rtl->rdata_o);
  }
  void wait() {
    for (int n = 0; !rtl->ack_o; ++n) {
      REQUIRE(n < 400);
      clock();
    }
  }
  // What the bus must read.
  std::int32_t expected(unsigned n, int word) const {
    return word <= 13 ? window.read(static_cast<int>(n), word) : twin[n].read(word);
  }

  // A tick and its law, in RTL and twin. Returns the clocks that it takes.
  int tick(bool commit = false) {
    apply();
    rtl->tick_i = 1;
    rtl->tick_pos_i = pos;
    rtl->commit_i = commit;
    rtl.eval();
    knots.clock(edge(true, false));
    const Precision::Knot knot =
        off(0) && off(1) ? Precision::Knot::kNone : knots.knot();
    REQUIRE(bool(rtl->underrun_o) ==
            (knot == Precision::Knot::kCoast || knot == Precision::Knot::kHold));
    if (commit) knots.clock(edge(false, true));
    for (unsigned n = 0; n < 2; ++n) {
      const Axis& a = axis[n];
      const bool reset = asked[n] || off(n);
      asked[n] = false;
      out[n] = twin[n].step({a.count, a.ticks, a.age, a.up, knot, reset}, window,
                            static_cast<int>(n));
    }
    rtl.tick();
    rtl->tick_i = rtl->tick_pos_i = rtl->commit_i = 0;
    int clocks = 0;
    for (; !rtl->done_o; ++clocks) {
      REQUIRE(clocks < 320);
      REQUIRE(rtl->busy_o);
      clock();
    }
    REQUIRE_FALSE(rtl->busy_o);
    for (unsigned n = 0; n < 2; ++n) {
      CAPTURE(n);
      REQUIRE(i_q_ref(n) == out[n].i_q_ref);
      REQUIRE(bool((rtl->saturated_o >> n) & 1) == out[n].saturated);
      REQUIRE(bool((rtl->clipped_o >> n) & 1) == out[n].clipped);
    }
    clock();
    return clocks;
  }

  std::int64_t i_q_ref(unsigned n) { return as_signed((rtl->i_q_ref_o >> (12 * n)) & 0xFFF, 12); }

  void require_same_words() {
    for (unsigned n = 0; n < 2; ++n) {
      for (int word = 0; word < 63; ++word) {
        if (word >= 32 && word != 54 && word < 59) continue;
        CAPTURE(n, word);
        REQUIRE(read(n, word) == expected(n, word));
      }
    }
  }

  // Gains of specification section 5, full set, and the default words of a mass.
  void full_gains(unsigned n, std::int32_t misc) {
    write(n, Word::kL1, gain(1673, -1));
    write(n, Word::kL2, gain(1882, -4));
    write(n, Word::kL3, gain(1267, -9));
    write(n, Word::kK1, gain(1475, -11));
    write(n, Word::kK2, gain(1720, -5));
    write(n, Word::kMisc, misc);
  }
  // What the law starts with: one tick in reset at this count, then a COMMIT for the next tick.
  void start(std::int32_t count) {
    axis[0].count = axis[1].count = count;
    tick();
    commit();
  }

  static std::int32_t gain(int mant, int exp) { return mant | ((exp & 31) << 16); }
  static std::int32_t misc(int lead, int knee, int sub_ticks, int hyst, bool rest) {
    return lead | (knee << 4) | (sub_ticks << 8) | (hyst << 12) | ((rest ? 1 : 0) << 20);
  }
};

}  // namespace trammel::test
