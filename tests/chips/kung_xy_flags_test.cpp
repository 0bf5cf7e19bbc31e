// SPDX-License-Identifier: Apache-2.0
//
// Bits of STATUS and IRQ_STAT of kung_xy that events set and a write of 1 clears, beside its twin
// and with the clocks of sleeping domains off: an event must wake the registers.
#include <Vkung_xy.h>

#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

#include "tests/chips/kung_pair.hpp"
#include "tests/support/flags.hpp"

using trammel::test::clears_what_it_shows;
namespace reg = trammel::kung_xy_regs;
namespace test = trammel::test;

namespace {

constexpr std::int64_t kPeriod = 3125;        // [clk] of 16 kHz
constexpr std::int64_t kTick = 8 * kPeriod;   // of 2 kHz
constexpr std::int64_t kKnot = 32 * kPeriod;  // of the precision controller
constexpr std::array<std::uint32_t, 2> kAxes{reg::kX, reg::kY};

struct Pair : test::KungPair<Vkung_xy> {
  Pair() {
    rtl().reset();
    begin();
    clocks(200);  // encoder lines adopted, rule tables filled
    gated = true;
  }
  void to_phase(std::int64_t period, std::int64_t phase) {
    clocks(((phase - now()) % period + period) % period);
  }
  bool shows(std::uint32_t address, std::uint32_t bit) { return (read(address) & bit) != 0; }
};

// `cause`, which can be repeated, clears the bit and leads to an event within `after` clocks.
template <class Cause>
void check(Pair& pair, std::uint32_t address, std::uint32_t bit, std::int64_t after, Cause cause) {
  CAPTURE(address, bit);
  clears_what_it_shows(
      0, after,
      [&](std::int64_t n) {
        cause();
        pair.clocks(n);
        return pair.shows(address, bit);
      },
      [&](std::int64_t n) {
        cause();
        pair.clocks(n);
        pair.write(address, bit);
        pair.clocks(after - n);
        return pair.shows(address, bit);
      });
}

// Of an event in each `period`, within 40 clocks behind `phase`.
void check_at(Pair& pair, std::uint32_t address, std::uint32_t bit, std::int64_t period,
              std::int64_t phase) {
  check(pair, address, bit, 40, [&pair, address, bit, period, phase] {
    pair.to_phase(period, phase - 30);
    pair.write(address, bit);
    pair.to_phase(period, phase);
  });
}

// Both axes under the precision controller at count 0, with these words; the phase of its knots.
using Words = std::array<std::uint32_t, 14>;
std::int64_t begin_precision(Pair& pair, const Words& words) {
  constexpr std::uint32_t kOn = reg::kCtrlPrecision | reg::kCtrlPositionLoop;
  pair.write(reg::kIrqPeriod, 255);  // its ticks wake the registers too
  for (const std::uint32_t base : kAxes) {
    pair.write(base + reg::kCtrl, kOn | reg::kCtrlResetModel);
    pair.write(base + reg::kPrecAddr, 0);
    for (const std::uint32_t word : words) pair.write(base + reg::kPrecData, word);
    pair.write(base + reg::kCtrl, kOn);
  }
  pair.clocks(kTick);  // the law in reset
  pair.to_phase(kTick, kTick / 2);
  pair.write(reg::kCommit, reg::kCommitTake);
  pair.to_phase(kTick, 0);
  const std::int64_t knot = pair.now();
  pair.clocks(kPeriod);
  return knot;
}

constexpr Words kNoGain{};
constexpr Words kGains{0,        0,        0x1D042C, 0x407AC,  0,        0x1E0446, 0, 0,
                       0x1F0689, 0x1C075A, 0x1704F3, 0x1505C3, 0x1B06B8, 0x11AF46};
constexpr std::uint32_t kNear = 1000;  // counts that saturate i_q* with these gains
constexpr std::uint32_t kFar = 5000;   // beyond 2048 the error is clipped

struct Flag {
  const char* name;
  const Words& words;
  std::uint32_t counts, set_point, bit;  // [count]
};
constexpr Flag kOfTheLaw[] = {{"saturated", kGains, kNear, 0, reg::kStatusSaturated},
                              {"clipped", kNoGain, 0, kFar, reg::kStatusClipped}};

// The axis away from its set point; without gains the estimate stays where it is.
void stray(Pair& pair, std::uint32_t base, const Flag& flag) {
  pair.write(base + reg::kPosPreset, flag.counts);
  pair.write(base + reg::kPrecAddr, 0);
  pair.write(base + reg::kPrecData, 256 * flag.set_point);
  for (int knot = 0; knot < 4; ++knot) {
    pair.write(reg::kCommit, reg::kCommitTake);
    pair.clocks(kKnot);
  }
}

}  // namespace

TEST_CASE("an event in the very clock of the write that clears its bit is kept") {
  Pair pair;
  pair.write(reg::kIrqPeriod, 1);
  for (const std::uint32_t base : kAxes) {  // far off, with high gains
    pair.write(base + reg::kKp, 4u << 16 | 2047);
    pair.write(base + reg::kKpCur, 4u << 16 | 2047);
    pair.write(base + reg::kPosCmd, 100000);
    pair.write(base + reg::kCtrl,
               reg::kCtrlEnable | reg::kCtrlCurrentLoop | reg::kCtrlPositionLoop);
  }
  pair.write(reg::kCommit, reg::kCommitTake);
  pair.clocks(5 * kTick);  // interrupts were each four ticks
  for (const std::uint32_t base : kAxes) {
    check_at(pair, base + reg::kStatus, reg::kStatusSaturated, kTick, 40);
    check_at(pair, base + reg::kStatus, reg::kStatusLimited, kTick, 110);
  }
  check_at(pair, reg::kIrqStat, reg::kIrqStatTick, kTick, -20);
}

// STATUS.overrun is not among them: both controllers end long before their next tick.
TEST_CASE("an encoder's error or a fault in the very clock of the clearing write is kept") {
  constexpr int kTrip = trammel::xy::kTripPin;
  for (const std::size_t axis : {0u, 1u}) {
    Pair pair;
    const std::uint32_t status = kAxes[axis] + reg::kStatus;
    check(pair, status, reg::kStatusQepError, 40, [&] {  // both lines at once
      pair.write(status, reg::kStatusQepError);
      pair.clocks(40);
      pair.lines ^= std::uint64_t{3} << 3 * axis;
    });
  }
  Pair pair;
  check(pair, reg::kIrqStat, reg::kIrqStatFault, 40, [&] {
    pair.lines = 0;
    pair.clocks(40);
    pair.write(reg::kFaultClear, reg::kKeyFaultClear);
    pair.write(reg::kIrqStat, reg::kIrqStatFault);
    pair.clocks(40);
    pair.lines = std::uint64_t{1} << kTrip;
  });
}

TEST_CASE("an event of the precision controller in the clock of the clearing write is kept") {
  for (const std::uint32_t base : kAxes) {
    CAPTURE(base);
    for (const Flag& flag : kOfTheLaw) {
      CAPTURE(flag.name);
      Pair pair;
      begin_precision(pair, flag.words);
      stray(pair, base, flag);
      // No tick of the position, so no knot: the law takes 229 clocks.
      check_at(pair, base + reg::kStatus, flag.bit, kTick, 3 * kPeriod + 210);
    }
    Pair pair;
    const std::int64_t knot = begin_precision(pair, kNoGain);
    check_at(pair, base + reg::kStatus, reg::kStatusUnderrun, kKnot, knot - 20);
  }
}

// A tick of the position wakes the registers anyway, as the end of its sample.
TEST_CASE("a saturated i_q* and a clipped error wake the registers at each tick of the carrier") {
  for (const std::uint32_t base : kAxes) {
    for (const Flag& flag : kOfTheLaw) {
      Pair pair;
      begin_precision(pair, flag.words);
      stray(pair, base, flag);
      for (std::int64_t tick = 0; tick < 8; ++tick) {
        CAPTURE(base, flag.name, tick);
        const std::uint32_t other = reg::kX + reg::kY - base;
        pair.to_phase(kTick, tick * kPeriod + 100);
        pair.write(base + reg::kStatus, ~0u);
        pair.to_phase(kTick, tick * kPeriod + 400);
        const std::uint32_t told = pair.read(base + reg::kStatus);
        CHECK((told & (reg::kStatusSaturated | reg::kStatusClipped)) == flag.bit);
        CHECK_FALSE(pair.shows(other + reg::kStatus, flag.bit));
      }
    }
  }
}
