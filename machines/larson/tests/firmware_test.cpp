// SPDX-License-Identifier: Apache-2.0
//
// The routines of .TABLE at the words of an interface that moves at once: what they write, and what
// they answer.
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>

#include "machines/larson/tests/fake_table.hpp"

using namespace trammel::sw;
using namespace trammel::test;

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

TEST_CASE("CALTBL of a table longer than Larson's looks for its switches as much farther") {
  StepTableSetup setup;
  setup.soft_end = 30'000;
  Program program({kCal, kWhere}, setup);
  for (FakeTable::Axis& axis : program.bus.axes) {
    axis.at = 29'000;
    axis.high = 31'000;
  }
  program.run();
  CHECK(program.app.mailbox().failure == 0);
  CHECK(program.bus.axes[0].at == 1);
}

TEST_CASE("an interrupt whose axis is busy, or that is of no axis, changes nothing") {
  StepTable table((StepTableSetup()));
  FakeTable bus;
  table.caltbl(bus);
  const std::size_t starts = bus.starts.size();
  for (const std::uint32_t vector : {map::kVectorX, map::kVectorY, 0350u}) {
    table.on_vector(bus, vector);
  }
  CHECK(table.busy());
  CHECK(bus.starts.size() == starts);
  CHECK(bus.axes[0].count == 0xFFFF - 12'000);
  CHECK(table.whrtbl(bus).x == 0);
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

TEST_CASE("WTTBL returns when its timer is over, once after each move, at once where none is set") {
  for (const std::uint32_t settle_clk : {0u, 777u}) {
    CAPTURE(settle_clk);
    StepTableSetup setup;
    setup.settle_clk = settle_clk;
    Program program({kCal, {LarsonOp::kAbstbl, 3, 0}, kWait, kWait, {LarsonOp::kAbstbl, 0, -1},
                     kWait, kWait},
                    setup);
    program.app.start(program.bus);
    std::uint32_t waits = 0, moving = 0;
    while (program.app.mailbox().done == 0) {
      if (program.bus.irq()) program.app.isr(program.bus);
      if (program.bus.timer == 777) {  // it waits, and nothing moves
        ++waits;
        moving += program.app.table().busy() ? 1 : 0;
        CHECK(program.app.mailbox().done == 0);
      }
      if (program.app.mailbox().done == 0) program.bus.step();
    }
    CHECK(waits == (settle_clk != 0 ? 3u : 0u));  // CALTBL and two moves
    CHECK(moving == 0);
    CHECK(program.answers[2].value == 1);
    CHECK(program.answers[3].value == 1);
    CHECK(program.answers[5].value == 0);  // clipped; told once
    CHECK(program.answers[6].value == 1);
  }
}

TEST_CASE("an axis that interrupts while WTTBL waits leaves the timer to run") {
  StepTableSetup setup;
  setup.settle_clk = 777;
  Program program({kCal, kWait}, setup);
  program.app.start(program.bus);
  while (program.bus.timer != 777) {
    if (program.bus.irq()) program.app.isr(program.bus);
    if (program.bus.timer != 777) program.bus.step();
  }
  for (FakeTable::Axis& axis : program.bus.axes) {
    axis.status |= map::kEnable;
    axis.done = true;
    const std::size_t before = program.bus.timers.size();
    program.app.isr(program.bus);
    CHECK_FALSE(axis.done);
    CHECK(program.bus.timer == 777);
    CHECK(program.bus.timers.size() == before);
    CHECK(program.app.mailbox().done == 0);
  }
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

TEST_CASE("BIC clears bits of a word, MOVB writes one byte, POLL waits until bits are 0") {
  StepTableSetup setup;
  setup.poll_clk = 777;
  Program program({{LarsonOp::kMov, 0, 0177774}, {LarsonOp::kMov, 1, 037704},
                   {LarsonOp::kPoll, 1, 010000}, {LarsonOp::kBic, 1, 020700},
                   {LarsonOp::kMovb, 7, 0377}},
                  setup);
  program.run();
  CHECK(program.app.mailbox().point == 5);
  CHECK(program.bus.axes[0].count == map::kTerminal);
  CHECK(program.bus.axes[0].status == 07004);
  CHECK(program.bus.timers.size() > 3);  // once for each step, and to end
  CHECK(program.bus.timers.front() == 777);
  CHECK(program.bus.bytes == std::vector<std::uint32_t>{map::byte(7), 0377});
}
