// SPDX-License-Identifier: Apache-2.0
//
// Calls that come too early, too late or one upon the other, and what each leaves behind for the
// next one.
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "machines/larson/tests/fake_table.hpp"

using namespace trammel::sw;
using namespace trammel::test;

namespace {

constexpr auto kNotYet = static_cast<std::int32_t>(StepAnswer::kNotCalibrated);
constexpr auto kStillMoves = static_cast<std::int32_t>(StepAnswer::kMoving);

}  // namespace

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
    CHECK(program.app.table().calibrated());  // by the CALTBL behind it
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

TEST_CASE("the setup of a table is Larson's: 5980 steps, at most 4000 pulses per second") {
  const StepTableSetup setup;
  CHECK(setup.soft_end == 5980);
  CHECK(setup.margin == 10);
  CHECK(setup.seek_rate == 400);
  CHECK(setup.back_rate == 100);
  CHECK(setup.most_rate == 4000);
  CHECK(setup.settle_clk == 25 * 50'000);  // 25 ms
}
