// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>

#include "tests/motion/lm628_engine_bench.hpp"
#include "tests/support/random.hpp"
#include "tests/support/same.hpp"

using trammel::exact::Lm628Engine;
using trammel::exact::Opcode;
using trammel::test::EngineBench;
using trammel::test::number;
using trammel::test::Random;

namespace {

std::uint16_t word(Random& random) {
  const unsigned bits = 1 + random() % 16;
  const std::uint32_t value = random() % (1u << bits);
  return static_cast<std::uint16_t>(random() % 4 == 0 ? 0u - value : value);
}

// High words are small more often than not, so that moves come to their ends.
Lm628Engine::Words words(Random& random) {
  Lm628Engine::Words w{};
  for (auto& one : w) one = word(random);
  if (random() % 4 != 0) {
    for (const std::size_t high : {1U, 3U, 5U}) {
      w[high] = static_cast<std::uint16_t>(random() % 8 - (random() % 3 == 0 ? 4 : 0));
    }
  }
  return w;
}

Opcode opcode(Random& random) {
  static constexpr std::array<Opcode, 21> kAll{
      Opcode::kStt,   Opcode::kDfh,  Opcode::kSip,  Opcode::kUdf,  Opcode::kPort8, Opcode::kPort12,
      Opcode::kRddv,  Opcode::kRddp, Opcode::kRdip, Opcode::kRdrp, Opcode::kRdrv,  Opcode::kRdsigs,
      Opcode::kRdsum, Opcode::kLpes, Opcode::kLpei, Opcode::kMski, Opcode::kRsti,  Opcode::kLfil,
      Opcode::kLtrj,  Opcode::kSbpa, Opcode::kSbpr};
  if (random() % 3 == 0) return Opcode::kStt;
  return random() % 3 == 0 ? Opcode::kLtrj : kAll[random() % kAll.size()];
}

}  // namespace

TEST_CASE("L-15 lm628_engine agrees with its twin on 10,000 random commands, sample by sample") {
  EngineBench bench;
  Random random(31);
  for (int n = 0; n < 10000; ++n) {
    if (random() % 3000 == 0) bench.reset();
    if (random() % 500 == 0) bench.wrap = !bench.wrap;
    Lm628Engine::Words w = words(random);
    const Opcode op = opcode(random);
    if (op == Opcode::kLtrj && random() % 4 != 0) w[0] &= 0xF8FF;  // no stop
    if (op == Opcode::kLpes && random() % 4 != 0) w[0] = 0x7FFF;
    INFO("command " << n << ", opcode " << number(static_cast<int>(op)) << " with "
                    << number(w[0], 4));
    bench.command(op, w);
    if (op == Opcode::kSip) bench.arm_index();
    const unsigned samples = random() % (random() % 16 == 0 ? 30 : 3);
    for (unsigned k = 0; k < samples; ++k) {
      INFO("sample " << k + 1 << " after it");
      switch (n / 1000 % 3) {
        case 0:  // as ordered
          bench.count += bench.twin().error();
          break;
        case 1:
          bench.count += static_cast<std::int64_t>(random() % 41) - 20;
          break;
        default:
          bench.count += bench.twin().error() / 8 + static_cast<std::int64_t>(random() % 5) - 2;
      }
      if (random() % 40 == 0) bench.index(bench.count - random() % 100);
      bench.sample();
    }
  }
  CHECK(bench.longest_sample() <= 400);
  CHECK(bench.longest_command() <= 127);
}

namespace {

Lm628Engine::Words trajectory(unsigned control, std::int64_t first, std::int64_t second = 0,
                              std::int64_t third = 0) {
  Lm628Engine::Words w{static_cast<std::uint16_t>(control)};
  std::size_t n = 1;
  for (const std::int64_t value : {first, second, third}) {
    w[n++] = static_cast<std::uint16_t>(value >> 16);
    w[n++] = static_cast<std::uint16_t>(value);
  }
  return w;
}

void start(EngineBench& bench, const Lm628Engine::Words& w) {
  bench.command(Opcode::kLtrj, w);
  bench.command(Opcode::kStt);
}

// The motor follows; a move rarely comes to its end before the next one is begun.
void follow(EngineBench& bench, unsigned samples) {
  for (; samples > 0; --samples) {
    bench.count += bench.twin().error();
    bench.sample();
  }
}

}  // namespace

// Whole counts a sample meet the target exactly with speed left; fractions find every remainder.
TEST_CASE("L-15 lm628_engine agrees with its twin on 3,000 moves that change in motion") {
  EngineBench bench;
  Random random(32);
  for (int n = 0; n < 3000; ++n) {
    CAPTURE(n);
    const bool whole = n % 1000 < 300;
    const auto fraction = [&](std::int64_t x) { return whole ? x / 65536 * 65536 : x; };
    const std::int64_t a = fraction(1 + random() % (random() % 2 == 0 ? 400000 : 4000));
    const std::int64_t v = fraction(random() % (random() % 2 == 0 ? 2000000 : 300000));
    const std::int64_t here = bench.twin().desired().position >> 16;
    const std::int64_t way = static_cast<std::int64_t>(random() % 61) - 30;
    switch (random() % 16) {
      case 0:
        start(bench, trajectory(0x0400, 0));
        break;
      case 1:
        start(bench, trajectory(random() % 2 == 0 ? 0x0200 : 0x0100, 0));
        break;
      case 2:
        start(bench, trajectory(0x0808 | (random() % 2 << 12), v));
        break;
      case 3:  // at rest a new acceleration is taken; off and on again it is taken in motion
        start(bench, trajectory(0x0100, 0));
        if (random() % 2 == 0) bench.sample();
        start(bench, trajectory(0x002A, random() % 8 == 0 ? 0 : a, v, here + way));
        break;
      case 4:
        start(bench, trajectory(0x0008, v));
        break;
      case 5:
        start(bench, trajectory(0x0002, here));
        break;
      default:
        start(bench, trajectory(0x000A, v, here + way));
    }
    follow(bench, 1 + random() % (random() % 16 == 0 ? 60 : 4));
  }
  CHECK(bench.longest_sample() <= 400);
}

TEST_CASE("lm628_engine reports a wraparound as the position passes +-2^30, there and back") {
  for (const std::int64_t direction : {1, -1}) {
    EngineBench bench;
    int wraps = 0;
    for (int n = 0; n < 140; ++n) {  // 2^23 - 1 counts are the most that a sample can tell
      bench.count += direction * ((1 << 23) - 1);
      bench.sample();
      wraps += (bench.events >> trammel::exact::kWraparound & 1u) != 0;
    }
    REQUIRE(wraps == 1);
    REQUIRE(bench.twin().actual() == direction * 140 * ((1 << 23) - 1));
    for (int n = 0; n < 20; ++n) {
      bench.count -= direction * ((1 << 23) - 1);
      bench.sample();
      wraps += (bench.events >> trammel::exact::kWraparound & 1u) != 0;
    }
    REQUIRE(wraps == 2);
  }
}

TEST_CASE("lm628_engine fires a breakpoint once as it is passed, from below or above, or at once") {
  for (int k = 0; k < 6; ++k) {
    const int bp = k % 3 * 40 - 40;
    EngineBench bench;
    if (k < 3) bench.command(Opcode::kLtrj, trajectory(0x0002, 5000));  // waits for STT
    bench.command(Opcode::kSbpa, {static_cast<std::uint16_t>(bp < 0 ? 0xFFFF : 0),
                                  static_cast<std::uint16_t>(bp)});
    int fired = 0;
    for (int n = 0; n < 20; ++n) {
      bench.count += bp < 0 ? -7 : 7;
      bench.sample();
      if ((bench.events >> trammel::exact::kBreakpoint & 1u) == 0) continue;
      ++fired;
      REQUIRE(std::abs(bench.count) == (bp == 0 ? 7 : 42));
    }
    REQUIRE(fired == 1);
  }
}

TEST_CASE("lm628_engine takes no index that came before SIP, also where no sample lies between") {
  constexpr unsigned kIndexSeen = 1u << 3;  // of the status byte
  EngineBench bench;
  const auto arm = [&] {
    bench.command(Opcode::kSip);
    bench.arm_index();
  };
  arm();
  bench.index(5);
  arm();
  bench.sample();
  CHECK((bench.events & kIndexSeen) == 0);
  CHECK(bench.command(Opcode::kRdip) == 0);
  bench.index(7);
  bench.sample();
  CHECK((bench.events & kIndexSeen) != 0);
  CHECK(bench.command(Opcode::kRdip) == 7);
}
