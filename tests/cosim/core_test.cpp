// SPDX-License-Identifier: Apache-2.0
//
// What a processor's RTL is told to have taken, held against routines whose clocks are known.
#include "cosim/core.hpp"

#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "tests/support/no_plant.hpp"

using namespace trammel::cosim;

namespace {

constexpr Clk kAnswer = 3;   // [clk] of a transfer
constexpr Clk kEvery = 100;  // [clk] from one interrupt to the next
constexpr Clk kEnd = 390;    // three of them

// Interrupts each kEvery clocks, until a transfer is answered.
struct FakeChip final : Chip {
  Clk edge = 0, answered = kNever;
  bool line = false;

  Clk now() const override { return edge; }
  void sense(Lines) override {}
  void request(const BusOp&) override { answered = edge + kAnswer - 1; }
  Stop run(Clk end, const Plant&) override {
    while (edge < end) {
      const Clk at = edge++;
      unsigned why = 0;
      if (at == answered) {
        why |= kBusDone;
        line = false;
      }
      if (at % kEvery == kEvery - 1) {
        line = true;
        why |= kIrq;
      }
      if (why != 0) return {at, why};
    }
    return {edge - 1, kLimit};
  }
  Lines drive() const override { return 0; }
  bool irq() const override { return line; }
  std::uint32_t rdata() const override { return 0; }
};

// Of each routine the clocks in which it computes before each transfer, and behind the last.
struct FakeCore final : Core {
  std::vector<std::vector<Clk>> routines;
  std::size_t routine = 0, part = 0;
  Clk edge = 0, left = 0;
  bool waits = true;

  explicit FakeCore(std::vector<std::vector<Clk>> all) : routines(std::move(all)) {}
  void go_on() {
    if (++part < routines[routine].size()) {
      left = routines[routine][part];
    } else {
      waits = true;
      ++routine;
    }
  }
  bool last() const { return part + 1 == routines[routine].size(); }

  Clk now() const override { return edge; }
  Asks asks() const override {
    if (waits) return Asks::kInterrupt;
    return left > 0 ? Asks::kNothing : Asks::kTransfer;
  }
  BusOp transfer() const override { return {}; }
  void step() override {
    ++edge;
    if (left == 0) return;  // in a transfer
    if (--left == 0 && last()) go_on();
  }
  void answer(std::uint32_t) override {
    ++edge;
    go_on();
  }
  void interrupt(bool level) override {
    ++edge;
    if (!level || routine == routines.size()) return;
    waits = false;
    part = 0;
    left = routines[routine][0];
  }
  Clk still() override { return kEnd; }
  void skip(Clk to) override { edge = to; }
  std::optional<CoreTrap> trap() const override { return {}; }
};

struct Nobody final : Observer {
  void on(const Stop&, const Chip&, const Plant&) override {}
};

}  // namespace

TEST_CASE("each routine of a core is counted by itself: transfers, clocks in and between them") {
  FakeChip chip;
  trammel::test::NoPlant plant;
  Nobody nobody;
  Loop loop(chip, plant, nobody);
  FakeCore core({{5, 7, 9, 2}, {4, 1}, {6, 3, 8}});
  CoreRun run(loop, core, kEnd, [] { return false; }, [](const CoreTrap&) {});
  run.run();
  const auto told = [](const Spread& s) { return std::vector<Clk>{s.count, s.worst, s.sum}; };
  using V = std::vector<Clk>;
  CHECK(told(run.times().transfers) == V{3, 3, 3 + 1 + 2});
  CHECK(told(run.times().first) == V{3, 7, 6 + 5 + 7});  // the clock of the interrupt, too
  CHECK(told(run.times().between) == V{3, 9, 7 + 9 + 3});
  CHECK(told(run.times().answer) == V{6, kAnswer, 6 * kAnswer});
  CHECK(told(run.times().routine) == V{3, 33, 33 + 9 + 24});
}
