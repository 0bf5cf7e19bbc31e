// SPDX-License-Identifier: Apache-2.0
//
// What larson_xy keeps of an event until software takes it: the request of a done event, which a
// read of the vector takes, and the limit latch, which a reset of the channel clears.
#include <catch2/catch.hpp>

#include <cstddef>
#include <cstdint>

#include "tests/chips/larson_bench.hpp"
#include "tests/support/flags.hpp"

using trammel::test::clears_what_it_shows;
using trammel::test::LarsonBench;

namespace {

constexpr std::uint32_t kBusy = 010000, kForward = 020000, kReset = 040000, kEnable = 0100000;
constexpr std::uint32_t kRate = 07704;  // 4000 pulses a second
constexpr std::uint32_t kVectors[] = {0340, 0344};

std::uint32_t count(std::size_t axis) { return axis == 0 ? 0 : 4; }
std::uint32_t status(std::size_t axis) { return count(axis) + 2; }

// An axis in motion: its event is the end of the last step, or the switch that it runs into.
struct Move {
  std::size_t axis;
  bool trips;

  std::int64_t after() const { return trips ? 60 : 20'000; }  // [clk] the event has been
  void begin(LarsonBench& bench) const {
    bench.mov(count(axis), trips ? 0177000 : 0177776);
    bench.mov(status(axis), kEnable | kBusy | kForward | kRate);
    if (!trips) return;
    bench.leaps = false;
    bench.watch = [&bench, axis = axis, at = bench.now() + 20] {
      if (bench.now() >= at) trammel::test::set_bit(bench.in.limit_high_i, axis, true);
    };
  }
  // [clk] from the begin to the edge of the event.
  std::int64_t lasts() const {
    LarsonBench bench;
    begin(bench);
    const std::int64_t from = bench.now();
    REQUIRE(bench.until([&] { return bench.irq(); }, after()));
    return bench.now() - from;
  }
};

constexpr Move kMoves[] = {{0, false}, {0, true}, {1, false}, {1, true}};

// take(move, n) of each move, n clocks behind its begin: the clocks around its event.
template <class Take>
void around_each_event(const Take& take) {
  for (const Move& move : kMoves) {
    const std::int64_t event = move.lasts();
    for (std::int64_t n = event - 6; n < event + 4; ++n) {
      CAPTURE(move.axis, move.trips, event, n);
      take(move, n);
    }
  }
}

}  // namespace

TEST_CASE("larson_xy: a done event in the very clock of a read of the vector is kept") {
  for (const Move& move : kMoves) {
    CAPTURE(move.axis, move.trips);
    clears_what_it_shows(
        0, move.after(),
        [&](std::int64_t n) {
          LarsonBench bench;
          move.begin(bench);
          bench.clocks(n);
          const std::uint32_t vector = bench.vector();
          CHECK((vector == 0 || vector == kVectors[move.axis]));
          return vector != 0;
        },
        [&](std::int64_t n) {
          LarsonBench bench;
          move.begin(bench);
          bench.clocks(n);
          bench.vector();
          bench.clocks(move.after() - n);
          return bench.irq();
        });
  }
}

TEST_CASE("larson_xy: a grant takes no done event of the other axis, whichever clock it is in") {
  around_each_event([](const Move& move, std::int64_t n) {
    LarsonBench bench;
    bench.mov(status(1 - move.axis), kEnable | kBusy | kRate);  // with nothing to do: done
    REQUIRE(bench.irq());
    move.begin(bench);
    bench.clocks(n);
    const std::uint32_t first = bench.vector();
    bench.clocks(move.after() - n);
    const std::uint32_t second = bench.vector();
    CHECK((first == kVectors[0] || first == kVectors[1]));
    CHECK(first + second == kVectors[0] + kVectors[1]);
    CHECK(bench.vector() == 0);
  });
}

TEST_CASE("larson_xy: a reset in the very clock of a done event or a trip leaves none of it") {
  around_each_event([](const Move& move, std::int64_t n) {
    LarsonBench bench;
    move.begin(bench);
    bench.clocks(n);
    bench.mov(status(move.axis), kReset | kEnable | kForward | kRate);
    bench.clocks(move.after() - n);
    CHECK_FALSE(bench.irq());
    CHECK_FALSE(bench.axis(move.axis).flush);
    CHECK((bench.word(status(move.axis)) & kBusy) == 0);
  });
}
