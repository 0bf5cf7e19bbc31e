// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>

#include "tests/motion/lm628_engine_bench.hpp"
#include "tests/support/random.hpp"

using trammel::exact::Lm628Engine;
using trammel::exact::Opcode;
using trammel::test::EngineBench;
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
    CAPTURE(n);
    if (random() % 3000 == 0) bench.reset();
    if (random() % 500 == 0) bench.wrap = !bench.wrap;
    Lm628Engine::Words w = words(random);
    const Opcode op = opcode(random);
    if (op == Opcode::kLtrj && random() % 4 != 0) w[0] &= 0xF8FF;  // no stop
    if (op == Opcode::kLpes && random() % 4 != 0) w[0] = 0x7FFF;
    bench.command(op, w);
    if (op == Opcode::kSip) bench.arm_index();
    const unsigned samples = random() % (random() % 16 == 0 ? 30 : 3);
    for (unsigned k = 0; k < samples; ++k) {
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
