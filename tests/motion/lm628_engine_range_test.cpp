// SPDX-License-Identifier: Apache-2.0
//
// The ends of the 32-bit positions, against plain arithmetic and not the twin's: desired position,
// actual position and breakpoint all go from 2^31 - 1 to -2^31 and back. In velocity mode a motor
// may turn for ever; were one of the positions not to wrap, the two would part there. Replies
// have 31 bits: the data sheet's range ends at 2^30 - 1.

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>

#include "tests/motion/lm628_engine_bench.hpp"

using trammel::exact::Lm628Engine;
using trammel::exact::Opcode;
using trammel::test::as_signed;
using trammel::test::EngineBench;

namespace {

constexpr std::int64_t kEnd = std::int64_t{1} << 31;
constexpr std::int64_t kSpeed = 16000;         // [counts/sample]
constexpr std::int64_t kMost = (1 << 23) - 1;  // [counts] that one sample can tell

std::int64_t wrapped(std::int64_t position) {
  return as_signed(static_cast<std::uint64_t>(position), 32);
}

std::int64_t reported(std::int64_t position) {
  return as_signed(static_cast<std::uint64_t>(position), 31);
}

Lm628Engine::Words long_words(std::int64_t value) {
  return {static_cast<std::uint16_t>(value >> 16), static_cast<std::uint16_t>(value)};
}

// The RTL's replies; the bench compares them with the twin's too.
std::int64_t ask(EngineBench& bench, Opcode opcode) {
  bench.command(opcode);
  return as_signed(bench->reply_o, 32);
}

bool fired(const EngineBench& bench) {
  return (bench.events >> trammel::exact::kBreakpoint & 1u) != 0;
}

// With the motor off the desired position follows the actual one: to `position` in long strides.
void carry_to(EngineBench& bench, std::int64_t position) {
  while (bench.count != position) {
    const std::int64_t way = position - bench.count;
    bench.count += std::abs(way) < kMost ? way : way < 0 ? -kMost : kMost;
    bench.sample();
  }
}

// Velocity mode; an acceleration is taken at rest only.
void run(EngineBench& bench, std::int64_t direction, bool from_rest) {
  const unsigned forward = direction > 0 ? 0x1000 : 0;
  const auto speed = static_cast<std::uint16_t>(kSpeed);
  if (from_rest) {
    bench.command(Opcode::kLtrj, {static_cast<std::uint16_t>(forward | 0x0828), speed, 0, speed});
  } else {
    bench.command(Opcode::kLtrj, {static_cast<std::uint16_t>(forward | 0x0808), speed, 0});
  }
  bench.command(Opcode::kStt);
}

}  // namespace

TEST_CASE("lm628_engine in velocity mode goes on from 2^31 - 1 at -2^31, and back from there") {
  EngineBench bench;
  carry_to(bench, kEnd - 5 * kSpeed - 1);
  bench.command(Opcode::kLfil, {0x0008, 1});  // the output is the error
  bench.command(Opcode::kUdf);
  std::int64_t desired = bench.count;  // never wrapped
  REQUIRE(ask(bench, Opcode::kRddp) == reported(desired));
  for (const std::int64_t direction : {1, -1}) {
    run(bench, direction, direction > 0);
    int crossed = 0;
    for (int n = 0; n < 10; ++n) {
      const std::int64_t before = wrapped(desired);
      bench.count = desired;  // the motor is a sample behind
      // The first sample after a turn slows down to rest: acceleration and speed are the same.
      const std::int64_t step = direction < 0 && n == 0 ? 0 : direction * kSpeed;
      desired += step;
      bench.sample();
      CAPTURE(direction, n, desired);
      crossed += std::abs(wrapped(desired) - before) > kEnd;
      REQUIRE(ask(bench, Opcode::kRddp) == reported(desired));
      REQUIRE(ask(bench, Opcode::kRdrp) == reported(bench.count));
      // Where both are on the same side of the end, their difference is that of one sample.
      if (std::abs(wrapped(desired) - before) < kEnd) {
        REQUIRE(as_signed(bench->u_o, 16) == step);
      }
    }
    REQUIRE(crossed == 1);
  }
}

// Data sheet: positions are C0000000h to 3FFFFFFFh.
TEST_CASE("lm628_engine replies with positions of 31 bits and reports each crossing of their end") {
  EngineBench bench;
  constexpr std::int64_t kRange = kEnd / 2;
  const auto crossed = [&] { return (bench.events >> trammel::exact::kWraparound & 1u) != 0; };
  carry_to(bench, kRange - 1);
  REQUIRE_FALSE(crossed());
  bench.command(Opcode::kSip);
  bench.arm_index();
  struct Step {
    std::int64_t by, reply;
    bool crosses;
  };
  for (const Step& step : {Step{0, 0x3FFFFFFF, false}, Step{1, -kRange, true},
                           Step{5, 5 - kRange, false}, Step{-5, -kRange, false},
                           Step{-1, 0x3FFFFFFF, true}, Step{3, 2 - kRange, true}}) {
    bench.count += step.by;
    bench.sample();
    CAPTURE(step.by, step.reply);
    REQUIRE(crossed() == step.crosses);
    REQUIRE(ask(bench, Opcode::kRdrp) == step.reply);
    REQUIRE(ask(bench, Opcode::kRddp) == step.reply);  // off: it follows
  }
  bench.index(bench.count);
  bench.sample();
  REQUIRE(ask(bench, Opcode::kRdip) == 2 - kRange);
}

// The motor is ahead and beyond the end, so that on its way to the breakpoint it does not wrap.
TEST_CASE("lm628_engine adds a relative breakpoint across 2^31 to the desired position") {
  for (const std::int64_t direction : {1, -1}) {
    EngineBench bench;
    std::int64_t desired = direction * (kEnd - 2 * kSpeed);
    carry_to(bench, desired);
    run(bench, direction, true);
    bench.count += direction * 4 * kSpeed;
    bench.sample();
    desired += direction * kSpeed;
    bench.command(Opcode::kSbpr, long_words(direction * 7 * kSpeed));
    CAPTURE(direction, wrapped(bench.count), wrapped(desired + direction * 7 * kSpeed));
    int first = -1;
    for (int n = 1; n < 12; ++n) {
      bench.count += direction * kSpeed;
      bench.sample();
      if (!fired(bench)) continue;
      REQUIRE(first == -1);
      first = n;
    }
    REQUIRE(first == 4);  // 2 samples ahead of a position that is 6 beyond the end
  }
}

TEST_CASE("lm628_engine adds a relative breakpoint to a target at the end, modulo 2^32") {
  for (const std::int64_t direction : {1, -1}) {
    EngineBench bench;
    const std::int64_t target = direction > 0 ? kEnd - 16 : -kEnd + 16;
    bench.command(Opcode::kLtrj, {0x0002, static_cast<std::uint16_t>(target >> 16),
                                  static_cast<std::uint16_t>(target)});
    bench.command(Opcode::kStt);  // no speed: it stands, but the target is loaded
    bench.command(Opcode::kSbpr, long_words(direction * (kEnd - 1)));  // is 17 counts away
    CAPTURE(direction, wrapped(target + direction * (kEnd - 1)));
    int first = -1;
    for (int n = 1; n < 30 && first < 0; ++n) {
      bench.count = -direction * n;
      bench.sample();
      if (fired(bench)) first = n;
    }
    REQUIRE(first == 17);
  }
}
