// SPDX-License-Identifier: Apache-2.0
//
// The routines of .TABLE at the words of an interface that moves at once: what they write, what
// they answer, and what each leaves behind for the next one.
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>

#include "machines/larson/tests/fake_table.hpp"

using namespace trammel::sw;
using namespace trammel::test;

namespace {

constexpr auto kNotYet = static_cast<std::int32_t>(StepAnswer::kNotCalibrated);
constexpr auto kStillMoves = static_cast<std::int32_t>(StepAnswer::kMoving);

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

TEST_CASE("CALTBL of a switch that never opens ends the program") {
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

TEST_CASE("before CALTBL no move begins: -1, nothing is written, and nothing waits") {
  Program program({{LarsonOp::kAbstbl, 5, 6}, {LarsonOp::kReltbl, 5, 6}, kWait, kWhere});
  program.run(0);
  CHECK(program.app.mailbox().done == 1);
  CHECK(program.app.mailbox().failure == 0);
  CHECK(program.app.mailbox().point == 4);
  CHECK(program.answers[0].value == kNotYet);
  CHECK(program.answers[1].value == kNotYet);
  CHECK(program.answers[2].value == 1);
  CHECK(program.answers[3].at.x == 0);
  CHECK(program.answers[3].value == kNotYet);
  CHECK(program.bus.starts.empty());
  CHECK(program.bus.timers.empty());
}

TEST_CASE("a move during a move is refused by -2, whichever axis moves, and changes nothing") {
  for (const int axis : {0, 1}) {
    CAPTURE(axis);
    const std::int32_t x = axis == 0 ? 90 : 0, y = axis == 1 ? 80 : 0;
    Program program({kCal, {LarsonOp::kAbstbl, x, y}, {LarsonOp::kVeltbl, 500, 250},
                     {LarsonOp::kAbstbl, 7, 9000}, {LarsonOp::kReltbl, 7, -9000}, kWait, kWhere,
                     {LarsonOp::kReltbl, 1, 2}, kWait, kWhere});
    program.run_to(5);
    CHECK(program.answers[1].value == 0);
    CHECK(program.answers[3].value == kStillMoves);
    CHECK(program.answers[4].value == kStillMoves);
    CHECK(program.bus.starts.size() == 7);
    CHECK(program.bus.starts.back() == (map::kEnable | map::kBusy | map::kForward | 07704));
    program.run();
    CHECK(program.answers[5].value == 1);  // what was refused was not clipped either
    CHECK(program.answers[6].at.x == x);
    CHECK(program.answers[6].at.y == y);
    CHECK(program.answers[9].at.x == x + 1);
    CHECK(program.answers[9].at.y == y + 2);
    REQUIRE(program.bus.starts.size() == 9);
    CHECK((program.bus.starts[7] & map::kRate) == 4096 - 480);  // set during the move before
    CHECK((program.bus.starts[8] & map::kRate) == 4096 - 960);
  }
}

TEST_CASE("CALTBL waits for a move that is not over, forgets its error, and finds its zero anew") {
  Program program({kCal, {LarsonOp::kAbstbl, 40, -3}, kCal, kWhere, kWait,
                   {LarsonOp::kAbstbl, 6, 8}, kWait, kWhere});
  program.run_to(2);
  const std::size_t before = program.bus.starts.size();
  program.bus.step();
  if (program.bus.irq()) program.app.isr(program.bus);
  CHECK(program.bus.starts.size() == before);
  program.run();
  REQUIRE(program.app.mailbox().done == 1);
  CHECK(program.app.mailbox().failure == 0);
  CHECK(program.answers[3].at.x == 0);
  CHECK(program.answers[3].at.y == 0);
  CHECK(program.answers[4].value == 1);
  CHECK(program.answers[7].at.x == 6);
  CHECK(program.answers[7].at.y == 8);
  CHECK(program.bus.axes[0].at == 1 + 6);
  CHECK(program.bus.axes[1].at == 1 + 8);
}

TEST_CASE("a wait of a script is its own clocks, once, and a move goes on beside it") {
  StepTableSetup setup;
  setup.settle_clk = 0;
  Program program({kCal, {LarsonOp::kAbstbl, 3, 0}, {LarsonOp::kWait, 123'456, 9}, kWhere,
                   {LarsonOp::kWait, 2'147'483'647, 0}, kWait},
                  setup);
  program.run_to(3);
  CHECK(program.bus.timer == 123'456);
  const std::size_t timers = program.bus.timers.size();
  program.bus.step();
  program.app.isr(program.bus);
  CHECK(program.answers[3].at.x == 1);
  CHECK(program.bus.timer == 2'147'483'647);
  CHECK(program.bus.timers.size() == timers + 2);  // off, and the next one
  program.run();
  CHECK(program.app.mailbox().done == 1);
  CHECK(program.answers[5].value == 1);
}

TEST_CASE("where a switch ended a move WHRTBL tells it, from either side, and WTTBL tells once") {
  for (const bool high : {false, true}) {
    CAPTURE(high);
    StepTableSetup setup;
    setup.margin = 50;
    Program program({kCal, {LarsonOp::kAbstbl, 100, 60}, kWait,
                     {LarsonOp::kAbstbl, high ? 200 : 10, 60}, kWait, kWhere, kWait, kCal,
                     kWhere},
                    setup);
    program.run_to(4);
    FakeTable::Axis& x = program.bus.axes[0];
    (high ? x.high : x.low) = x.at + (high ? 20 : -20);
    program.run();
    CHECK(program.answers[4].value == 0);
    CHECK(program.answers[5].at.x == (high ? 120 : 80));
    CHECK(program.answers[5].at.y == 60);
    CHECK(program.answers[5].value == kNotYet);
    CHECK(program.answers[6].value == 1);
    CHECK(program.app.mailbox().failure == 0);
    CHECK(program.app.mailbox().calibrated);  // by the CALTBL behind it
    CHECK(program.answers[8].value == 0);
  }
}

TEST_CASE("CALTBL seeks 12 000 steps in a table of 6000, and 60 000 in a longer one") {
  for (const std::int32_t end : {5980, 6000, 6001, 30'000}) {
    CAPTURE(end);
    StepTableSetup setup;
    setup.soft_end = end;
    Program program({kCal}, setup);
    program.app.start(program.bus);
    const std::uint32_t far = end <= 6000 ? 12'000 : 60'000;
    for (const FakeTable::Axis& axis : program.bus.axes) CHECK(axis.count == 0xFFFF - far);
  }
}
