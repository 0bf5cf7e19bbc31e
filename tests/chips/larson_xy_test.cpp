// SPDX-License-Identifier: Apache-2.0
//
// Acceptance tests M-01 to M-08 and M-14 of the chip alone, each beside its twin; and random
// traffic. Numbers of words and bits are octal, as in Larson 1974.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/chips/larson_bench.hpp"
#include "tests/support/random.hpp"
#include "tests/support/traffic.hpp"

using trammel::test::LarsonBench;
using trammel::test::Random;
namespace exact = trammel::exact;

namespace {

constexpr std::uint32_t kBusy = 010000, kForward = 020000, kReset = 040000, kEnable = 0100000;
constexpr std::uint32_t kXCount = 0, kXStatus = 2, kYCount = 4, kYStatus = 6;
constexpr double kClockS = 20e-9;

std::uint32_t complement(std::uint32_t steps) { return ~steps & 0177777; }

// Rising edges of step of X, in clocks.
struct Steps {
  std::vector<std::int64_t> at;
  bool was = false;

  explicit Steps(LarsonBench& bench) {
    bench.watch = [this, &bench] {
      if (bench.axis(0).step && !was) at.push_back(bench.now());
      was = bench.axis(0).step;
    };
  }
  double seconds(std::size_t first, std::size_t last) const {
    return static_cast<double>(at[last] - at[first]) * kClockS;
  }
};

bool busy(const LarsonBench& bench, std::size_t axis) {
  return (bench.axis(axis).status & kBusy) != 0;
}

}  // namespace

TEST_CASE("M-01 rates of Table I, by the formula, within 0.05 % over 64 steps") {
  // Larson's row 7650 is a misprint: 3000 PPS are 7660.
  const std::pair<std::uint32_t, double> rows[] = {
      {01000, 66.96},  {03000, 93.75}, {05000, 156.25}, {07000, 468.75}, {07200, 625},
      {07400, 937.5},  {07550, 1578.9}, {07660, 3000},  {07700, 3750},   {07704, 4000}};
  for (const auto& [code, hertz] : rows) {
    LarsonBench bench;
    const Steps steps(bench);
    bench.mov(kXCount, complement(65));
    bench.mov(kXStatus, kBusy | kForward | code);
    REQUIRE(bench.until([&] { return !busy(bench, 0); }, 60'000'000));
    REQUIRE(steps.at.size() == 65);
    CHECK(64 / steps.seconds(0, 64) == Approx(hertz).epsilon(5e-4));
  }
}

TEST_CASE("M-02 five steps forward at 7704: five pulses, 177777, busy 0, the last 1.25 ms later") {
  LarsonBench bench;
  const Steps steps(bench);
  bench.mov(kXCount, 0177772);
  bench.mov(kXStatus, kBusy | kForward | 07704);
  const std::int64_t accepted = bench.now() - 1;  // the word acts at the second of three edges
  REQUIRE(bench.until([&] { return !busy(bench, 0); }, 1'000'000));
  REQUIRE(steps.at.size() == 5);
  CHECK(bench.word(kXCount) == 0177777);
  CHECK((bench.word(kXStatus) & kBusy) == 0);
  const double last = static_cast<double>(steps.at.back() - accepted) * kClockS;
  CHECK(std::fabs(last - 5 * 250e-6) <= 4.17e-6);
}

TEST_CASE("M-03 1000 steps at 7704 take 250 ms, and the rate bits stay as they are") {
  LarsonBench bench;
  const Steps steps(bench);
  bench.mov(kXCount, complement(1000));
  bench.mov(kXStatus, kBusy | 07704);
  const std::int64_t begin = bench.now();
  REQUIRE(bench.until([&] { return !busy(bench, 0); }, 20'000'000));
  CHECK(static_cast<double>(bench.now() - begin) * kClockS == Approx(0.25).epsilon(1e-3));
  CHECK(steps.at.size() == 1000);
  CHECK(bench.word(kXStatus) == 07704);
}

TEST_CASE("M-04 both axes end together: vector 340, then 344") {
  LarsonBench bench;
  for (const std::uint32_t axis : {kXCount, kYCount}) bench.mov(axis, complement(3));
  bench.mov(kYStatus, kEnable | kBusy | 07704);
  bench.mov(kXStatus, kEnable | kBusy | 07704);
  REQUIRE(bench.until([&] { return !busy(bench, 0) && !busy(bench, 1); }, 1'000'000));
  CHECK(bench.irq());
  CHECK(bench.vector() == 0340);
  CHECK(bench.irq());
  CHECK(bench.vector() == 0344);
  CHECK_FALSE(bench.irq());
  CHECK(bench.vector() == 0);
}

namespace {

// Forward at 400 PPS with `left` steps to go where the far switch closes.
void run_into_far_limit(LarsonBench& bench, const Steps& steps, std::uint32_t left) {
  bench.mov(kXCount, complement(left + 50));
  bench.mov(kXStatus, kEnable | kBusy | kForward | 06650);
  REQUIRE(bench.until([&] { return steps.at.size() == 50; }, 20'000'000));
  bench.in.limit_high_i = 1;
  REQUIRE(bench.until([&] { return !busy(bench, 0); }, 100));
}

}  // namespace

TEST_CASE("M-05 the far switch with 100 steps left: busy 0, bits 14 and 13, the count, interrupt") {
  LarsonBench bench;
  const Steps steps(bench);
  run_into_far_limit(bench, steps, 100);
  bench.clocks(1'000'000);
  CHECK(steps.at.size() == 50);
  CHECK((bench.word(kXStatus) & (kBusy | kReset | kForward)) == (kReset | kForward));
  CHECK(bench.word(kXCount) == complement(100));
  CHECK(bench.vector() == 0340);
  CHECK(bench.axis(0).flush);
}

TEST_CASE("M-06 at the switch a start backward without reset does nothing; after one it moves") {
  LarsonBench bench;
  const Steps steps(bench);
  run_into_far_limit(bench, steps, 100);
  bench.mov(kXCount, complement(10));
  bench.mov(kXStatus, kBusy | 06650);
  bench.clocks(1'000'000);
  CHECK(steps.at.size() == 50);
  CHECK((bench.word(kXStatus) & kBusy) == 0);
  bench.mov(kXStatus, kReset | 06650);
  bench.mov(kXStatus, kBusy | 06650);
  REQUIRE(bench.until([&] { return !busy(bench, 0); }, 20'000'000));
  CHECK(steps.at.size() == 60);
}

TEST_CASE("M-06 after a reset with the switch still closed, forward trips again without a step") {
  LarsonBench bench;
  const Steps steps(bench);
  run_into_far_limit(bench, steps, 100);
  bench.mov(kXStatus, kReset | kBusy | kForward | 06650);
  bench.clocks(500'000);
  CHECK(steps.at.size() == 50);
  CHECK(bench.axis(0).flush);
  CHECK((bench.word(kXStatus) & kBusy) == 0);
}

TEST_CASE("M-07 at the switch BIS 020000 writes the reset that it read: the latch is cleared") {
  LarsonBench bench;
  const Steps steps(bench);
  run_into_far_limit(bench, steps, 100);
  REQUIRE(bench.axis(0).flush);
  bench.bis(kXStatus, 020000);
  CHECK_FALSE(bench.axis(0).flush);
  CHECK_FALSE(bench.irq());  // the reset takes the done event with it
  // Away from a switch the same instruction changes nothing.
  bench.in.limit_high_i = 0;
  bench.clocks(10);
  bench.mov(kXCount, complement(5));
  bench.mov(kXStatus, kBusy | 07704);
  bench.bis(kXStatus, 0);
  REQUIRE(bench.until([&] { return !busy(bench, 0); }, 1'000'000));
  CHECK(steps.at.size() == 55);
}

TEST_CASE("M-08 busy in the word with the direction, or by a later BIS: the same motion") {
  std::array<std::vector<std::int64_t>, 2> times;
  for (std::size_t way = 0; way < 2; ++way) {
    LarsonBench bench;
    const Steps steps(bench);
    bench.mov(kXCount, complement(20));
    if (way == 0) {
      bench.mov(kXStatus, kBusy | kForward | 07400);
    } else {
      bench.mov(kXStatus, kForward | 07400);
      bench.clocks(1000);
      bench.bis(kXStatus, kBusy);
    }
    REQUIRE(bench.until([&] { return !busy(bench, 0); }, 20'000'000));
    CHECK(bench.axis(0).forward);
    for (const std::int64_t at : steps.at) times[way].push_back(at - steps.at.front());
  }
  REQUIRE(times[0].size() == 20);
  REQUIRE(times[1].size() == 20);
  for (std::size_t k = 0; k < 20; ++k) CHECK(std::abs(times[0][k] - times[1][k]) <= 1);
}

TEST_CASE("M-14 a byte written to 164003 leaves the register, and is counted") {
  LarsonBench bench;
  bench.mov(kXStatus, kEnable | kForward | 01234);
  bench.movb(kXStatus + 1, 0377);
  bench.movb(kXStatus, 0377);
  bench.movb(kYCount, 0);
  CHECK(bench.word(kXStatus) == (kEnable | kForward | 01234));
  CHECK(bench.word(kYCount) == 0177777);
  CHECK(bench.errors() == 3);
  for (int k = 3; k < 300; ++k) bench.movb(kXStatus, 0377);
  CHECK(bench.errors() == 300);
}

TEST_CASE("larson_xy: a start with 177777 is done at once; enabling a done event interrupts") {
  LarsonBench bench;
  bench.mov(kYStatus, kBusy | 07704);
  CHECK((bench.word(kYStatus) & kBusy) == 0);
  CHECK_FALSE(bench.irq());
  bench.mov(kYStatus, kEnable | 07704);
  CHECK(bench.irq());
  CHECK(bench.vector() == 0344);
}

TEST_CASE("larson_xy: busy waits for the buffer, a stop does not, and is no done event") {
  LarsonBench bench;
  bench.in.buf_busy_i = 1;
  bench.mov(kXCount, complement(2));
  bench.mov(kXStatus, kEnable | kBusy | 07704);
  bench.clocks(100'000);
  CHECK(bench.word(kXCount) == 0177777);
  CHECK((bench.word(kXStatus) & kBusy) != 0);
  bench.in.buf_busy_i = 0;
  bench.clocks(10);
  CHECK(bench.vector() == 0340);
  bench.mov(kXCount, complement(100));
  bench.mov(kXStatus, kEnable | kBusy | 07704);
  bench.clocks(50'000);
  const std::uint32_t left = bench.word(kXCount);
  bench.mov(kXStatus, kEnable | 07704);
  bench.clocks(50'000);
  CHECK(bench.word(kXCount) == left);
  CHECK_FALSE(bench.irq());
}

TEST_CASE("larson_xy in motion: a rate from the next preset on, a direction and a count at once") {
  LarsonBench bench;
  const Steps steps(bench);
  bench.mov(kXCount, complement(20));
  bench.mov(kXStatus, kBusy | kForward | 07704);
  REQUIRE(bench.until([&] { return steps.at.size() == 2; }, 1'000'000));
  bench.clocks(3000);
  bench.mov(kXStatus, kBusy | kForward | 07660);  // busy again: the divider goes on
  REQUIRE(bench.until([&] { return steps.at.size() == 4; }, 1'000'000));
  CHECK(std::fabs(steps.seconds(1, 2) - 60 / 240e3) < 30e-9);
  CHECK(std::fabs(steps.seconds(2, 3) - 80 / 240e3) < 30e-9);
  CHECK(bench.axis(0).forward);
  bench.mov(kXStatus, kBusy | 07660);
  REQUIRE(bench.until([&] { return steps.at.size() == 5; }, 1'000'000));
  CHECK_FALSE(bench.axis(0).forward);
  CHECK(bench.word(kXCount) == complement(15));
  bench.mov(kXCount, complement(2));
  REQUIRE(bench.until([&] { return !busy(bench, 0); }, 1'000'000));
  CHECK(steps.at.size() == 7);
}

TEST_CASE("larson_xy: a reset in motion stops it without a done event, and the count stays") {
  LarsonBench bench;
  const Steps steps(bench);
  bench.mov(kXCount, complement(20));
  bench.mov(kXStatus, kEnable | kBusy | kForward | 07704);
  REQUIRE(bench.until([&] { return steps.at.size() == 3; }, 1'000'000));
  bench.mov(kXStatus, kReset | kEnable | kForward | 07704);
  bench.clocks(100'000);
  CHECK(steps.at.size() == 3);
  CHECK_FALSE(bench.irq());
  CHECK(bench.word(kXCount) == complement(17));
  CHECK(bench.word(kXStatus) == (kEnable | kForward | 07704));
  bench.mov(kXStatus, kReset | kEnable | kBusy | kForward | 07704);  // both: it starts anew
  REQUIRE(bench.until([&] { return bench.irq(); }, 1'000'000));
  CHECK(steps.at.size() == 20);
}

TEST_CASE("larson_xy: a start that the latch refuses leaves the request as it is") {
  for (const bool taken : {false, true}) {
    CAPTURE(taken);
    LarsonBench bench;
    const Steps steps(bench);
    run_into_far_limit(bench, steps, 100);
    if (taken) CHECK(bench.vector() == 0340);
    bench.mov(kXStatus, kEnable | kBusy | 06650);
    CHECK(bench.irq() == !taken);
    CHECK_FALSE(busy(bench, 0));
  }
}

TEST_CASE("larson_xy agrees with its twin on random traffic, leaping and not") {
  const trammel::test::Traffic traffic = trammel::test::traffic(4000, 21);
  Random random(traffic.seed);
  LarsonBench bench;
  int steps = 0;
  bool was = false;
  bench.watch = [&] {
    steps += bench.axis(1).step && !was;
    was = bench.axis(1).step;
  };
  for (std::int64_t n = 0; n < traffic.transfers; ++n) {
    INFO("transfer " << n << "; " << traffic.until(n));
    bench.leaps = random() % 8 != 0;
    const auto pace = trammel::test::AxiPace::random(random, random() % 4 != 0);
    const std::uint32_t status = (random() & 0xF000) | (4095 - random() % 200);
    const std::uint32_t count = random() % 16 == 0 ? random() & 0xFFFF : 0xFFFF - random() % 8;
    const std::uint32_t data = random() % 10 == 0 ? random() : status << 16 | count;
    bench.transfer(random() % 4 * 4, data, random() % 3 != 0, pace);
    for (std::size_t k = 0; k < 2; ++k) {
      using trammel::test::set_bit;
      if (random() % 20 == 0) set_bit(bench.in.limit_low_i, k, random() % 4 == 0);
      if (random() % 20 == 0) set_bit(bench.in.limit_high_i, k, random() % 4 == 0);
      if (random() % 8 == 0) set_bit(bench.in.buf_busy_i, k, random() % 3 == 0);
    }
    if (random() % 3 == 0) bench.clocks(random() % (bench.leaps ? 40'000 : 800));
    if (random() % 400 == 0) bench.reset();
  }
  if (trammel::test::own_traffic()) CHECK(steps > 200);
}
