// SPDX-License-Identifier: Apache-2.0
//
// What STT takes: data sheet SNVS781C, "command STT must be executed to make the values effective",
// of which no condition is said, and that an acceleration is not changed in motion. Numbers are
// those of a host, not the twin's.

#include <catch2/catch.hpp>
#include <cstdint>

#include "tests/motion/lm628_engine_bench.hpp"

using trammel::exact::Lm628Engine;
using trammel::exact::Opcode;
using trammel::test::as_signed;
using trammel::test::EngineBench;

namespace {

constexpr unsigned kMotorOff = 0x0100, kAbruptly = 0x0200, kSmoothly = 0x0400;
constexpr unsigned kCommandError = 1u << 1;
constexpr unsigned kAcceleration = 0x4000;  // of the signals register
constexpr std::int64_t kA = 0x4000, kV = 0x40000, kGoal = 2000;

std::int64_t ask(EngineBench& bench, Opcode opcode) {
  bench.command(opcode);
  return as_signed(bench->reply_o, 32);
}
std::int64_t speed(EngineBench& bench) { return ask(bench, Opcode::kRddv); }
std::int64_t place(EngineBench& bench) { return ask(bench, Opcode::kRddp); }
unsigned signals(EngineBench& bench) {
  bench.command(Opcode::kRdsigs);
  return bench->reply_o;
}

void load(EngineBench& bench, unsigned control, std::initializer_list<std::int64_t> values = {}) {
  Lm628Engine::Words words{static_cast<std::uint16_t>(control)};
  std::size_t n = 1;
  for (const std::int64_t value : values) {
    words[n++] = static_cast<std::uint16_t>(value >> 16);
    words[n++] = static_cast<std::uint16_t>(value);
  }
  bench.command(Opcode::kLtrj, words);
}

// Returns the events of STT.
unsigned start(EngineBench& bench) {
  bench.command(Opcode::kStt);
  return bench.events;
}
unsigned stop(EngineBench& bench, unsigned how) {
  load(bench, how);
  return start(bench);
}

// The motor follows.
void samples(EngineBench& bench, int n) {
  for (; n > 0; --n) {
    bench.sample();
    bench.count += bench.twin().error();
  }
}
void to_the_end(EngineBench& bench) {
  int n = 0;
  while ((signals(bench) & 0x0400) == 0 && n++ < 3000) samples(bench, 1);
  samples(bench, 1);
}

void move(EngineBench& bench) {
  load(bench, 0x002A, {kA, kV, kGoal});
  REQUIRE(start(bench) == 0);
  samples(bench, 60);
  REQUIRE(speed(bench) == kV);
}

}  // namespace

TEST_CASE("lm628_engine goes on to its target by STT alone after each kind of stop") {
  for (const unsigned how : {kMotorOff, kAbruptly, kSmoothly}) {
    CAPTURE(how);
    EngineBench bench;
    move(bench);
    stop(bench, how);
    samples(bench, 40);
    REQUIRE(speed(bench) == 0);
    const std::int64_t rest = place(bench);
    REQUIRE(rest > 0);
    REQUIRE(rest < kGoal / 2);
    REQUIRE(start(bench) == 0);
    samples(bench, 20);
    REQUIRE(place(bench) > rest);
    to_the_end(bench);
    REQUIRE(place(bench) == kGoal);
    REQUIRE(ask(bench, Opcode::kRdrp) == kGoal);
  }
}

TEST_CASE("lm628_engine holds where a stop has left it until STT") {
  for (const unsigned how : {kAbruptly, kSmoothly}) {
    EngineBench bench;
    move(bench);
    stop(bench, how);
    to_the_end(bench);
    const std::int64_t rest = place(bench);
    samples(bench, 100);
    REQUIRE(place(bench) == rest);
  }
}

TEST_CASE("lm628_engine keeps its physical end over DFH in motion, STT takes the number anew") {
  for (const bool again : {false, true}) {
    CAPTURE(again);
    EngineBench bench;
    move(bench);
    samples(bench, 20);
    const std::int64_t home = ask(bench, Opcode::kRdrp);
    REQUIRE(home > 100);
    bench.command(Opcode::kDfh);
    REQUIRE(ask(bench, Opcode::kRdrp) == 0);
    if (again) REQUIRE(start(bench) == 0);
    to_the_end(bench);
    REQUIRE(place(bench) == (again ? kGoal : kGoal - home));
    REQUIRE(bench.count == (again ? kGoal + home : kGoal));
  }
}

TEST_CASE("lm628_engine keeps a breakpoint at its place on the shaft over DFH") {
  for (const int way : {1, -1}) {
    CAPTURE(way);
    EngineBench bench;
    for (int n = 0; n < 20; ++n) {
      bench.count += 5 * way;
      bench.sample();
    }
    const auto at = static_cast<std::uint32_t>(160 * way);
    bench.command(Opcode::kSbpa, {static_cast<std::uint16_t>(at >> 16),
                                  static_cast<std::uint16_t>(at)});
    bench.command(Opcode::kDfh);
    int fired = 0;
    for (int n = 0; n < 40; ++n) {
      bench.count += 7 * way;
      bench.sample();
      if ((bench.events >> trammel::exact::kBreakpoint & 1u) == 0) continue;
      ++fired;
      REQUIRE(bench.count == 163 * way);  // the first place beyond 160
    }
    REQUIRE(fired == 1);
  }
}

TEST_CASE("lm628_engine adds a relative position once, to the target at its STT") {
  EngineBench bench;
  load(bench, 0x002B, {kA, kV, 300});
  for (int n = 0; n < 3; ++n) {  // the sum is the buffer: no second 300
    start(bench);
    to_the_end(bench);
    REQUIRE(place(bench) == 300);
  }
  load(bench, 0x0003, {200});
  load(bench, 0x0003, {-50});  // replaces the 200
  bench.command(Opcode::kDfh);
  REQUIRE(place(bench) == 0);
  start(bench);
  to_the_end(bench);
  REQUIRE(place(bench) == -50);
}

TEST_CASE("lm628_engine adds a relative position to where it is as velocity mode is left") {
  EngineBench bench;
  load(bench, 0x1828, {kA, kV});
  start(bench);
  samples(bench, 100);
  const std::int64_t here = place(bench);
  load(bench, 0x0003, {1000});
  samples(bench, 7);
  const std::int64_t there = place(bench);
  REQUIRE(there > here);
  start(bench);
  to_the_end(bench);
  REQUIRE(place(bench) == there + 1000);
}

TEST_CASE("lm628_engine keeps a position that is loaded in velocity mode for position mode") {
  EngineBench bench;
  load(bench, 0x182A, {kA, kV, 77});
  start(bench);
  samples(bench, 100);
  REQUIRE(speed(bench) == kV);
  REQUIRE(place(bench) > 77);
  load(bench, 0x0000);
  start(bench);
  to_the_end(bench);
  REQUIRE(place(bench) == 77);
}

TEST_CASE("lm628_engine makes every stop with an acceleration loaded, at the one in use") {
  for (const unsigned how : {kMotorOff, kAbruptly, kSmoothly}) {
    CAPTURE(how);
    EngineBench bench;
    move(bench);
    load(bench, 0x0020, {4 * kA});
    REQUIRE(start(bench) == kCommandError);
    samples(bench, 1);
    REQUIRE(speed(bench) == kV);
    REQUIRE((stop(bench, how) & kCommandError) == 0);
    REQUIRE((signals(bench) & kAcceleration) != 0);
    samples(bench, 1);
    REQUIRE(speed(bench) == (how == kSmoothly ? kV - kA : 0));
    REQUIRE(((signals(bench) & 0x0080) != 0) == (how == kMotorOff));
    samples(bench, 40);
    REQUIRE(speed(bench) == 0);
    REQUIRE(start(bench) == 0);  // at rest it is taken
    REQUIRE((signals(bench) & kAcceleration) == 0);
    samples(bench, 1);
    REQUIRE(speed(bench) == 4 * kA);
  }
}

TEST_CASE("lm628_engine refuses STT with an acceleration loaded while a smooth stop ramps down") {
  EngineBench bench;
  move(bench);
  load(bench, 0x0020, {4 * kA});
  stop(bench, kSmoothly);
  samples(bench, 2);
  REQUIRE(start(bench) == kCommandError);
  samples(bench, 2);
  REQUIRE(speed(bench) == kV - 4 * kA);
}
