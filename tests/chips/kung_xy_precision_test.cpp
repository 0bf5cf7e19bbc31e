// SPDX-License-Identifier: Apache-2.0
//
// The precision controller behind the registers of kung_xy: its window, its sums, its place in the
// axis. That every word is the twin's is shown under random traffic; the law has its own tests.
#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

#include "models/exact/control/precision.hpp"
#include "tests/chips/kung_bench.hpp"
#include "tests/chips/kung_pair.hpp"

namespace reg = trammel::kung_xy_regs;
using trammel::exact::Precision;
using trammel::test::KungBench;
namespace test = trammel::test;

namespace {

constexpr std::uint32_t kOn = reg::kCtrlPrecision | reg::kCtrlPositionLoop;

void write_window(KungBench& chip, std::uint32_t base, std::uint32_t word, std::int32_t value) {
  chip.write(base + reg::kPrecAddr, word);
  chip.write(base + reg::kPrecData, static_cast<std::uint32_t>(value));
}

// Clocks of which those that only count are leapt over.
void wait(KungBench& chip, int clocks) {
  for (const std::int64_t end = chip.now() + clocks; chip.now() < end;) chip.leap_edge();
}

// Both axes out of reset at count 0, with no gains: i_q* is what IFF says.
void leave_reset(KungBench& chip) {
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    chip.write(base + reg::kCtrl, kOn | reg::kCtrlResetModel);
    for (std::uint32_t word = 0; word < 14; ++word) write_window(chip, base, word, 0);
    chip.write(base + reg::kCtrl, kOn);
  }
  chip.to_tick();  // a law in reset
  chip.edges(400);
}

}  // namespace

TEST_CASE("PREC_DATA reads and writes the window, and PREC_ADDR counts up behind it") {
  KungBench chip;
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    CAPTURE(base);
    chip.write(base + reg::kPrecAddr, 0);
    for (std::uint32_t word = 0; word < 14; ++word) {
      chip.write(base + reg::kPrecData, 1000 * (word + 1) + base);
    }
    CHECK(chip.read(base + reg::kPrecAddr) == 14);
    chip.write(base + reg::kPrecAddr, 0);
    for (std::uint32_t word = 0; word < 14; ++word) {
      CAPTURE(word);
      CHECK(chip.read(base + reg::kPrecData) == (word == 7 ? 0 : 1000 * (word + 1) + base));
    }
    chip.write(base + reg::kPrecAddr, 31);
    CHECK(chip.read(base + reg::kPrecData) == 0);
    CHECK(chip.read(base + reg::kPrecAddr) == 0);
  }
  SECTION("some bytes of a word change nothing") {
    chip.write(reg::kX + reg::kPrecAddr, 3);
    chip->s_axil_wstrb_i = 0x7;
    chip.write(reg::kX + reg::kPrecData, 77);
    chip->s_axil_wstrb_i = 0xf;
    CHECK(chip.read(reg::kX + reg::kPrecAddr) == 3);
    CHECK(chip.read(reg::kX + reg::kPrecData) == 4000);
  }
}

TEST_CASE("with CTRL.precision the fuzzy controller rests and the law ends the sample") {
  KungBench chip;
  chip.to_tick();
  CHECK(chip.to_sample() <= 71);
  chip.write(reg::kX + reg::kCtrl, kOn);
  chip.write(reg::kY + reg::kCtrl, kOn);
  chip.to_tick();
  chip.edges(20);
  CHECK((chip.read(reg::kX + reg::kStatus) & reg::kStatusBusy) == 0);
  chip.to_tick();
  CHECK(chip.to_sample() == Precision::kClocks + 1);
  // One axis with each: the sample waits for the law.
  chip.write(reg::kY + reg::kCtrl, reg::kCtrlPositionLoop);
  chip.to_tick();
  CHECK(chip.to_sample() >= Precision::kClocks + 1);
}

TEST_CASE("the words of a COMMIT are taken by the next knot, 32 ticks after the one before") {
  KungBench chip;
  leave_reset(chip);
  CHECK(chip.read(reg::kKnot) == 0);
  write_window(chip, reg::kX, 1, 25600);  // IFF: i_q* of 100, reached over 32 ticks
  write_window(chip, reg::kY, 1, -12800);
  CHECK(chip.read_signed(reg::kX + reg::kIqCmd) == 0);
  chip.write(reg::kCommit, reg::kCommitTake);
  chip.to_tick();
  chip.edges(400);
  CHECK(chip.read(reg::kKnot) == 1);
  CHECK(chip.read_signed(reg::kX + reg::kIqCmd) == 3);  // 100 / 32
  chip.write(reg::kCommit, reg::kCommitTake);
  wait(chip, 32 * 3125);
  CHECK(chip.read(reg::kKnot) == 2);
  CHECK(chip.read_signed(reg::kX + reg::kIqCmd) == 100);
  CHECK(chip.read_signed(reg::kY + reg::kIqCmd) == -50);
  // 3, 6, ... 100: the mean of the ramp, over 32 ticks.
  CHECK(chip.read_signed(reg::kX + reg::kIqSum) == Approx(32 * 51.5).margin(32));
  CHECK(chip.read_signed(reg::kX + reg::kErrSum) == 0);
  CHECK((chip.read(reg::kX + reg::kStatus) & reg::kStatusUnderrun) == 0);
  SECTION("a knot without a COMMIT is an underrun, until 1 is written") {
    wait(chip, 32 * 3125);
    CHECK(chip.read(reg::kKnot) == 3);
    for (const std::uint32_t base : {reg::kX, reg::kY}) {
      CHECK((chip.read(base + reg::kStatus) & reg::kStatusUnderrun) != 0);
      chip.write(base + reg::kStatus, reg::kStatusUnderrun);
      CHECK((chip.read(base + reg::kStatus) & reg::kStatusUnderrun) == 0);
    }
  }
  SECTION("an axis that another controller has is told of none") {
    chip.write(reg::kY + reg::kCtrl, reg::kCtrlPositionLoop);
    wait(chip, 32 * 3125);
    CHECK((chip.read(reg::kX + reg::kStatus) & reg::kStatusUnderrun) != 0);
    CHECK((chip.read(reg::kY + reg::kStatus) & reg::kStatusUnderrun) == 0);
  }
  SECTION("CTRL.reset_model ends the count of knots and the current") {
    for (const std::uint32_t base : {reg::kX, reg::kY}) {
      chip.write(base + reg::kCtrl, kOn | reg::kCtrlResetModel);
    }
    wait(chip, 3125 + 400);
    CHECK(chip.read(reg::kKnot) == 0);
    CHECK(chip.read_signed(reg::kX + reg::kIqCmd) == 0);
  }
}

TEST_CASE("KNOT counts those of the axis that is on, whichever it is") {
  for (const std::uint32_t alone : {reg::kX, reg::kY}) {
    CAPTURE(alone);
    KungBench chip;
    leave_reset(chip);
    chip.write((reg::kX ^ reg::kY ^ alone) + reg::kCtrl, reg::kCtrlPositionLoop);
    for (std::uint32_t knot = 1; knot <= 3; ++knot) {
      chip.write(reg::kCommit, reg::kCommitTake);
      wait(chip, 32 * 3125);
      CHECK(chip.read(reg::kKnot) == knot);
    }
  }
}

TEST_CASE("an i_q* beyond its range is saturated and told by the status of its axis") {
  KungBench chip;
  leave_reset(chip);
  write_window(chip, reg::kX, 1, 1 << 24);
  for (int knot = 0; knot < 3; ++knot) {
    chip.write(reg::kCommit, reg::kCommitTake);
    wait(chip, 32 * 3125);
  }
  CHECK(chip.read_signed(reg::kX + reg::kIqCmd) == 2047);
  CHECK((chip.read(reg::kX + reg::kStatus) & reg::kStatusSaturated) != 0);
  CHECK((chip.read(reg::kY + reg::kStatus) & reg::kStatusSaturated) == 0);
}

TEST_CASE("an error beyond 2048 counts is clipped and told, and PREC_ERR shows it") {
  KungBench chip;
  leave_reset(chip);
  write_window(chip, reg::kX, 0, 256 * 4000);
  for (int knot = 0; knot < 4; ++knot) {
    chip.write(reg::kCommit, reg::kCommitTake);
    wait(chip, 32 * 3125);
  }
  CHECK((chip.read(reg::kX + reg::kStatus) & reg::kStatusClipped) != 0);
  CHECK((chip.read(reg::kY + reg::kStatus) & reg::kStatusClipped) == 0);
  CHECK(chip.read_signed(reg::kX + reg::kPrecErr) == 2048 * 256 - 1);
  CHECK(chip.read_signed(reg::kY + reg::kPrecErr) == 0);
}

TEST_CASE("between the counts each axis has its own edges, way and filter, as in the twin") {
  struct Move {
    std::uint32_t base, filter;
  };
  constexpr std::array<Move, 2> kMoves{{{reg::kX, 3}, {reg::kY, 8}}};
  struct Phase {
    std::array<int, 2> every;  // an edge in so many times 2400 clocks
    std::array<int, 2> way;
    std::uint32_t sub_ticks;
  };
  // Either way; edges that are younger and older than SUB_TICKS, and than any number of it.
  constexpr std::array<Phase, 5> kPhases{{{{5, 8}, {1, -1}, 15},
                                          {{3, 2}, {1, -1}, 1},
                                          {{13, 21}, {-1, 1}, 6},
                                          {{40, 40}, {-1, 1}, 15},
                                          {{8, 5}, {1, -1}, 12}}};
  constexpr int kKnots = 3;  // of a phase
  constexpr std::array<std::uint32_t, 14> kWords{
      0, 0, 0x1D042C, 0x407AC, 0, 0x1E0446, 0, 0, 0x1F0689, 0x1C075A, 0x1704F3, 0x1505C3, 0x1B06B8,
      6 | 4 << 4 | 26 << 12 | 1 << 20};
  test::KungPair<Vkung_xy> pair;
  pair.rtl().reset();
  pair.begin();
  pair.clocks(200);
  pair.gated = true;
  const auto window = [&pair](std::uint32_t base, std::uint32_t word, std::uint32_t value) {
    pair.write(base + reg::kPrecAddr, word);
    pair.write(base + reg::kPrecData, value);
  };
  for (const Move& move : kMoves) {
    pair.write(move.base + reg::kCtrl, kOn | reg::kCtrlResetModel);
    pair.write(move.base + reg::kDeadtime, 100 | move.filter << reg::kDeadtimeQepFilterShift);
    for (std::uint32_t word = 0; word < 14; ++word) window(move.base, word, kWords[word]);
    pair.write(move.base + reg::kCtrl, kOn);
  }
  pair.clocks(2 * 3125);
  std::array<int, 2> between{};
  std::array<std::uint32_t, 2> told{};
  std::array<std::int32_t, 2> place{};
  constexpr int kLast = static_cast<int>(kPhases.size()) * kKnots;
  for (int knot = 0; knot < kLast + 2; ++knot) {
    const bool far = knot >= kLast;  // clipped, saturated
    const Phase& phase = kPhases[static_cast<std::size_t>(far ? 0 : knot / kKnots)];
    for (std::size_t n = 0; n < 2; ++n) {
      place[n] += phase.way[n] * 40 / phase.every[n];
      window(kMoves[n].base, 13, kWords[13] | phase.sub_ticks << 8);
      window(kMoves[n].base, 0, static_cast<std::uint32_t>(256 * (far ? 100000 : place[n])));
    }
    if (knot != 5) pair.write(reg::kCommit, reg::kCommitTake);
    for (int at = 0; at < 40; ++at) {
      for (std::size_t n = 0; n < 2; ++n) {
        if (at % phase.every[n] == 0) pair.count(static_cast<int>(n), phase.way[n]);
      }
      pair.clocks(2400);
    }
    for (std::size_t n = 0; n < 2; ++n) {
      const std::uint32_t base = kMoves[n].base;
      pair.write(base + reg::kPrecAddr, 16);
      for (int word = 16; word < 23; ++word) {
        const std::uint32_t value = pair.read(base + reg::kPrecData);
        if (word == 22 && value % 256 != 0) ++between[n];
      }
      told[n] |= pair.read(base + reg::kStatus);
      pair.read(base + reg::kIqCmd);
    }
  }
  for (std::size_t n = 0; n < 2; ++n) {
    CHECK(between[n] > 3);
    CHECK((told[n] & reg::kStatusUnderrun) != 0);
    CHECK((told[n] & reg::kStatusClipped) != 0);
  }
}
