// SPDX-License-Identifier: Apache-2.0
//
// The routines of .TABLE at the words of an interface that moves at once: what they write, and what
// they answer.
#include <catch2/catch.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "sw_nios/apps/larson/larson.hpp"
#include "sw_nios/apps/larson/larson_map.hpp"

using namespace trammel::sw;
namespace map = trammel::sw::larson_map;

namespace {

// Two axes between switches, a step at a time when told to; and the platform's timer.
struct FakeTable final : Bus {
  struct Axis {
    std::uint32_t count = map::kTerminal, status = 0;
    bool latch = false, done = false;
    int at = 5, low = -10, high = 6000;
    bool closed_always = false;  // the lower one
    bool closed() const { return closed_always || at <= low || at >= high; }
  };
  Axis axes[2];
  std::uint32_t timer = 0;
  bool timer_irq = false;
  std::vector<std::uint32_t> starts;  // status words that said start

  std::uint32_t read(std::uint32_t address) override {
    if (address == map::kIrq) {
      return (vector() != 0 ? map::kIrqChip : 0) | (timer_irq ? map::kIrqTimer : 0);
    }
    if (address == map::kVector) {
      const std::uint32_t taken = vector();
      if (taken != 0) axes[taken == map::kVectorX ? 0 : 1].done = false;
      return taken;
    }
    const Axis& a = axes[address / 8];
    return address % 8 == 0 ? a.count : a.status | (a.closed() ? map::kLimit : 0);
  }

  void write(std::uint32_t address, std::uint32_t data) override {
    if (address == map::kTimer) {
      timer = data;
      timer_irq = false;
      return;
    }
    Axis& a = axes[address / 8];
    if (address % 8 == 0) {
      a.count = data;
      return;
    }
    if ((data & map::kReset) != 0) a.latch = a.done = false;
    a.status = data & ~map::kLimit & (a.latch ? ~map::kBusy : ~0u);
    if ((a.status & map::kBusy) != 0) {
      starts.push_back(data);
      a.done = false;
    }
  }

  std::uint32_t vector() const {
    const auto asks = [](const Axis& a) { return a.done && (a.status & map::kEnable) != 0; };
    return asks(axes[0]) ? map::kVectorX : asks(axes[1]) ? map::kVectorY : 0;
  }
  bool irq() const { return vector() != 0 || timer_irq; }

  void step() {
    for (Axis& a : axes) {
      if ((a.status & map::kBusy) == 0) continue;
      const bool forward = (a.status & map::kForward) != 0;
      if (forward ? a.at >= a.high : a.closed_always || a.at <= a.low) {
        a.latch = true;
      } else if (a.count != map::kTerminal) {
        a.at += forward ? 1 : -1;
        ++a.count;
      }
      if (a.latch || a.count == map::kTerminal) {
        a.status &= ~map::kBusy;
        a.done = true;
      }
    }
    if (timer != 0) {
      timer = 0;
      timer_irq = true;
    }
  }
};

struct Program {
  std::vector<LarsonCall> calls;
  std::vector<LarsonAnswer> answers;
  FakeTable bus;
  LarsonApp app;

  explicit Program(std::vector<LarsonCall> all, const StepTableSetup& setup = {})
      : calls(std::move(all)),
        answers(calls.size()),
        app(setup, calls.data(), answers.data(), static_cast<std::uint32_t>(calls.size())) {}

  void run(int steps = 200'000) {
    app.start(bus);
    while (app.mailbox().done == 0 && steps-- > 0) {
      if (bus.irq()) app.isr(bus);
      if (app.mailbox().done == 0) bus.step();
    }
  }
};

constexpr LarsonCall kCal{LarsonOp::kCaltbl, 0, 0}, kWait{LarsonOp::kWttbl, 0, 0},
    kWhere{LarsonOp::kWhrtbl, 0, 0};

}  // namespace

TEST_CASE("CALTBL backs into both switches, leaves them, and calls (0, 0) what is ten steps on") {
  Program program({kCal, kWhere});
  program.run();
  REQUIRE(program.app.mailbox().done == 1);
  CHECK(program.app.mailbox().failure == 0);
  CHECK(program.bus.axes[0].at == 1);  // it opens at -9
  CHECK(program.bus.axes[1].at == 1);
  CHECK(program.answers[1].at.x == 0);
  REQUIRE(program.bus.starts.size() == 6);
  // 400 pulses per second back, 100 forward and again.
  CHECK(program.bus.starts[0] == (map::kEnable | map::kBusy | (4096 - 600)));
  CHECK(program.bus.starts[2] == (map::kEnable | map::kBusy | map::kForward | (4096 - 2400)));
}

TEST_CASE("CALTBL that finds no switch, or none that opens, ends the program") {
  Program none({kCal, kWait});
  none.bus.axes[1].low = -200'000;
  none.run(300'000);
  CHECK(none.app.mailbox().failure == static_cast<std::uint32_t>(LarsonFailure::kNotCalibrated));
  CHECK(none.bus.axes[1].at == 5 - 12'000);  // 30 s at 400 pulses per second
  Program stuck({kCal, kWait});
  stuck.bus.axes[0].high = -20;  // both are closed
  stuck.run(300'000);
  CHECK(stuck.app.mailbox().failure == static_cast<std::uint32_t>(LarsonFailure::kNotCalibrated));
  Program closed({kCal, kWait});
  closed.bus.axes[0].closed_always = true;
  closed.run(300'000);
  CHECK(closed.app.mailbox().failure ==
        static_cast<std::uint32_t>(LarsonFailure::kNotCalibrated));
  CHECK(closed.bus.axes[0].at <= 5 + 2000);
}

TEST_CASE("velocities become rate codes, at most 4000 pulses per second") {
  const StepTable table((StepTableSetup()));
  CHECK(table.code(4000) == 07704);
  CHECK(table.code(9000) == 07704);
  CHECK(table.code(3750) == 07700);
  CHECK(table.code(1250) == 07500);
  CHECK(table.code(59) == 4096 - 4068);
  CHECK(table.code(1) == 0);
  CHECK(table.code(3999) == 07704);  // 60 ticks are nearest
}

TEST_CASE("a move loads the complement of its steps, and WHRTBL reads it back in motion") {
  Program program({kCal,
                   {LarsonOp::kVeltbl, 1000, 1000},
                   {LarsonOp::kAbstbl, 30, 0},
                   kWhere,
                   {LarsonOp::kWait, 1, 0},
                   kWhere,
                   kWait,
                   kWhere});
  program.run();
  REQUIRE(program.app.mailbox().done == 1);
  CHECK(program.answers[3].at.x == 0);
  CHECK(program.answers[5].at.x == 1);  // the timer of this table is one step
  CHECK(program.answers[6].value == 1);
  CHECK(program.answers[7].at.x == 30);
  CHECK(program.bus.axes[0].at == 31);
}

TEST_CASE("targets outside the soft range are clipped, WTTBL tells once, calibration stays") {
  Program program({kCal,
                   {LarsonOp::kAbstbl, -5, 7000},
                   kWait,
                   kWhere,
                   {LarsonOp::kReltbl, 3, -10},
                   kWait,
                   kWhere});
  program.run();
  REQUIRE(program.app.mailbox().done == 1);
  CHECK(program.answers[2].value == 0);
  CHECK(program.answers[3].at.x == 0);
  CHECK(program.answers[3].at.y == 5980);
  CHECK(program.answers[5].value == 1);
  CHECK(program.answers[6].at.x == 3);
  CHECK(program.answers[6].at.y == 5970);
  CHECK(program.app.table().calibrated());
}

TEST_CASE("a switch in a move is an error return, and the table asks to be calibrated again") {
  Program program({kCal, {LarsonOp::kAbstbl, 500, 0}, kWait, {LarsonOp::kAbstbl, 5, 5}});
  program.bus.axes[0].high = 300;
  program.run();
  REQUIRE(program.app.mailbox().done == 1);
  CHECK(program.answers[2].value == 0);
  CHECK_FALSE(program.app.table().calibrated());
  CHECK(program.answers[3].value == static_cast<int>(StepAnswer::kNotCalibrated));
}

TEST_CASE("MOV writes a word, BIS reads and writes it, with the reset it finds there") {
  Program program({{LarsonOp::kMov, 2, 0177772}, {LarsonOp::kMov, 3, 020123},
                   {LarsonOp::kBis, 3, 0100000}});
  program.bus.axes[1].at = -10;
  program.bus.axes[1].latch = true;
  program.run();
  CHECK(program.bus.axes[1].count == 0177772);
  CHECK(program.bus.axes[1].status == 0120123);
  CHECK_FALSE(program.bus.axes[1].latch);
}
