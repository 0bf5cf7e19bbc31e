// SPDX-License-Identifier: Apache-2.0
//
// The core beside the loop, two chips in step, and the sample tick and timer of a chip without a
// bus, which no leap passes.
#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "cosim/core.hpp"
#include "cosim/machine_chip.hpp"
#include "cosim/processor_bus.hpp"
#include "cosim/verilated/in_step.hpp"
#include "tests/support/no_plant.hpp"

using namespace trammel::cosim;
using namespace trammel;

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

struct Registers {
  int count = 0;
  int input = 0;
};

struct Faults {
  bool leaps_too_far = false;   // its leaps count one clock more
  bool stops_too_late = false;  // a leaping chip sees its own event a clock later
};
Faults faults;

// Counts, and drives at every 100th clock; waiting is leapt over.
class Counter : public cosim::MachineChip {
 public:
  Counter(cosim::NoTrace, cosim::ModelMode mode) : leap_(mode.leap) {}

  cosim::Clk now() const override { return state_; }
  void sense(cosim::Lines lines) override { registers_.input = static_cast<int>(lines); }
  void request(const cosim::BusOp& op) override { registers_.count = static_cast<int>(op.data); }
  cosim::Stop run(cosim::Clk end, const cosim::Plant&) override {
    const cosim::Clk late = leap_ && faults.stops_too_late ? 1 : 0;
    const cosim::Clk event = state_ / 100 * 100 + 99 + late;
    const cosim::Clk last = std::min(end - 1, event);
    registers_.count += static_cast<int>(last + 1 - state_);
    if (leap_ && faults.leaps_too_far && last + 1 - state_ > 1) ++registers_.count;
    state_ = last + 1;
    ++evaluated_;
    return {last, last == event ? cosim::kDrive : cosim::kLimit};
  }
  cosim::Lines drive() const override { return 0; }
  bool irq() const override { return false; }
  std::uint32_t rdata() const override { return 0; }
  cosim::Clk evaluated() const override { return evaluated_; }

  Registers& registers() { return registers_; }
  cosim::Clk& state() { return state_; }

 private:
  bool leap_;
  Registers registers_;
  cosim::Clk state_ = 0, evaluated_ = 0;
};

struct Visited {
  template <class A, class B, class Visit>
  static void for_each(A& a, B& b, Visit visit) {
    visit("chip.count", a.count, b.count);
    visit("chip.input", a.input, b.input);
  }
};

using Audited = cosim::AuditedChip<Counter, Visited>;

// The failed assertion, if any, after some runs with a transfer and a changed pin between.
std::optional<cosim::FailedAssertion> audited(const Faults& wrong) {
  faults = wrong;
  Audited chip;
  const test::NoPlant plant;
  chip.run(60, plant);
  chip.sense(5);
  chip.run(150, plant);
  chip.request({0, 40, true});
  while (chip.now() < 1000) chip.run(1000, plant);
  faults = {};
  return chip.failed_assertion();
}

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

TEST_CASE("chips that agree break no assertion, and from outside look like the first one") {
  CHECK_FALSE(audited({}));
  Audited chip;
  CHECK(chip.run(1000, test::NoPlant()).edge == 99);
  CHECK(chip.now() == 100);
  CHECK(chip.evaluated() == 1);
  CHECK(chip.registers().count == 100);
}

TEST_CASE("a leap that counts one clock too many is reported with register, values and clock") {
  const auto broken = audited({true, false});
  REQUIRE(broken);
  CHECK(broken->name == "leap_is_exact");
  CHECK(broken->instance == "chip.count");
  CHECK(broken->place == "60 plain, 61 leapt");
  CHECK(broken->edge == 59);
}

TEST_CASE("a stop that comes at another clock is reported with both clocks and reasons") {
  const auto broken = audited({false, true});
  REQUIRE(broken);
  CHECK(broken->instance == "the stop");
  CHECK(broken->edge == 99);
  CHECK(broken->place == "99 for 2 plain, 100 for 2 leapt");
}

TEST_CASE("the sample tick is the last edge of each period, and the edge before a leap's end") {
  ProcessorBus board;
  board.ticks[0] = 100;
  for (Clk edge = 0; edge < 300; ++edge) {
    CHECK(board.samples(edge) == (edge % 100 == 99));
    const Clk waiting = board.waiting(edge);
    CHECK(waiting == (edge % 100 == 99 ? 1 : 99 - edge % 100));
    for (Clk passed = edge; passed < edge + waiting && waiting > 1; ++passed) {
      CHECK_FALSE(board.samples(passed));
    }
  }
}

TEST_CASE("a timer beside the chip ends the wait") {
  ProcessorBus board;
  board.ticks[0] = 1000;
  board.timer.write(10, 20);
  CHECK(board.waiting(11) == 19);
  CHECK(board.waiting(30) == 1);
}
