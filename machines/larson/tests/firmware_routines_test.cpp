// SPDX-License-Identifier: Apache-2.0
//
// The routines of .TABLE in each axis and sense, with values that differ between the axes: what is
// written to which word, and which axis an answer is of.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>

#include "machines/larson/tests/fake_table.hpp"

using namespace trammel::sw;
using namespace trammel::test;

namespace {

StepTableSetup unlike() {
  StepTableSetup s;
  s.soft_end = 500;
  s.margin = 17;
  s.seek_rate = 375;  // 640 ticks
  s.back_rate = 125;  // 1920
  s.most_rate = 3000;
  s.poll_clk = 4321;
  s.settle_clk = 98765;
  return s;
}

std::uint32_t failure(const Program& p) { return p.app.mailbox().failure; }

}  // namespace

TEST_CASE("CALTBL uses its own rates, margin and timer, and leaves each axis at its margin") {
  Program program({kCal, kWhere}, unlike());
  program.bus.axes[0].low = -20;
  program.bus.axes[1].low = -30;
  program.run();
  REQUIRE(failure(program) == 0);
  CHECK(program.bus.axes[0].at == -2);  // 17 from -19, where its switch opens
  CHECK(program.bus.axes[1].at == -12);
  CHECK(program.app.mailbox().calibrated);
  const auto& starts = program.bus.starts;
  REQUIRE(starts.size() == 6);
  constexpr std::uint32_t kRun = map::kEnable | map::kBusy;
  for (int k = 0; k < 6; ++k) {
    CAPTURE(k);
    const bool seeks = k < 2;
    CHECK(starts[static_cast<std::size_t>(k)] ==
          (kRun | (seeks ? 4096u - 640 : map::kForward | (4096u - 1920))));
  }
  const auto& timers = program.bus.timers;
  REQUIRE(timers.size() > 3);
  for (std::size_t k = 0; k < timers.size() - 2; ++k) CHECK((timers[k] == 0 || timers[k] == 4321));
  CHECK(timers[timers.size() - 2] == 98765);  // and returns when that is over
  CHECK(timers.back() == 0);
}

TEST_CASE("CALTBL fails where one axis alone finds no switch, or one that does not open") {
  for (const std::uint32_t axis : {0u, 1u}) {
    for (const bool opens : {false, true}) {
      CAPTURE(axis, opens);
      Program program({kCal, kWhere}, unlike());
      (opens ? program.bus.axes[axis].low : program.bus.axes[axis].high) = opens ? -200'000 : -50;
      program.run(300'000);
      CHECK(failure(program) == static_cast<std::uint32_t>(LarsonFailure::kNotCalibrated));
      CHECK_FALSE(program.app.mailbox().calibrated);
    }
  }
}

TEST_CASE("a move writes each axis its own steps, sense and rate, and an axis at rest nothing") {
  for (const std::int32_t x : {100, 101, 99, 140, 60}) {
    for (const std::int32_t y : {200, 270, 130}) {
      CAPTURE(x, y);
      Program program({kCal, {LarsonOp::kAbstbl, 100, 200}, kWait,
                       {LarsonOp::kVeltbl, 1000, 500}, {LarsonOp::kAbstbl, x, y}, kWhere, kWait,
                       kWhere},
                      unlike());
      std::size_t starts = 0;
      std::ptrdiff_t polls = 0;
      std::uint32_t counts[2] = {};
      program.app.start(program.bus);
      while (program.app.mailbox().point < 6) {
        if (program.bus.irq()) program.app.isr(program.bus);
        if (program.app.mailbox().point == 6) break;
        polls = std::count(program.bus.timers.begin(), program.bus.timers.end(), 4321u);
        starts = program.bus.starts.size();
        program.bus.step();
      }
      for (int k = 0; k < 2; ++k) counts[k] = program.bus.axes[k].count;
      const auto check = [&](int axis, std::int32_t way, std::uint32_t rate) {
        const auto& a = program.bus.axes[axis];
        if (way == 0) {
          CHECK((a.status & map::kBusy) == 0);
          return;
        }
        CHECK(counts[axis] == 0xFFFFu - static_cast<std::uint32_t>(way < 0 ? -way : way));
        CHECK(a.status == (map::kEnable | map::kBusy | (way > 0 ? map::kForward : 0) | rate));
      };
      check(0, x - 100, 4096 - 240);
      check(1, y - 200, 4096 - 480);
      CHECK(program.bus.starts.size() == starts + (x != 100) + (y != 200));
      program.run();
      CHECK(program.answers[5].at.x == 100);  // it has not moved yet
      CHECK(program.answers[5].at.y == 200);
      CHECK(program.answers[6].value == 1);
      CHECK(program.answers[7].at.x == x);
      CHECK(program.answers[7].at.y == y);
      // Once behind CALTBL and each move, for what it leaves in motion; else for switches only.
      const auto& timers = program.bus.timers;
      CHECK(std::count(timers.begin(), timers.end(), 98765u) == 2 + (x != 100 || y != 200));
      CHECK(std::count(timers.begin(), timers.end(), 4321u) == polls);
    }
  }
}

TEST_CASE("WHRTBL counts each axis in its own sense while both move") {
  for (const int sense_x : {1, -1}) {
    for (const int sense_y : {1, -1}) {
      CAPTURE(sense_x, sense_y);
      Program program({kCal, {LarsonOp::kAbstbl, 100, 200}, kWait,
                       {LarsonOp::kReltbl, 50 * sense_x, 60 * sense_y}, {LarsonOp::kWait, 1, 0},
                       kWhere, kWait, kWhere},
                      unlike());
      program.run();
      REQUIRE(failure(program) == 0);
      CHECK(program.answers[5].at.x == 100 + sense_x);
      CHECK(program.answers[5].at.y == 200 + sense_y);
      CHECK(program.answers[7].at.x == 100 + 50 * sense_x);
      CHECK(program.answers[7].at.y == 200 + 60 * sense_y);
    }
  }
}

TEST_CASE("each end of the soft range is reached, and clipped one beyond, in each axis") {
  for (const int axis : {0, 1}) {
    for (const std::int32_t target : {-1, 0, 500, 501}) {
      CAPTURE(axis, target);
      const std::int32_t x = axis == 0 ? target : 250, y = axis == 1 ? target : 250;
      Program program({kCal, {LarsonOp::kAbstbl, 250, 250}, kWait, {LarsonOp::kAbstbl, x, y},
                       kWait, kWhere, {LarsonOp::kAbstbl, 250, 250}, kWait},
                      unlike());
      program.run();
      CHECK(program.answers[4].value == (target == 0 || target == 500 ? 1 : 0));
      const std::int32_t clipped = target < 0 ? 0 : target > 500 ? 500 : target;
      CHECK(program.answers[5].at.x == (axis == 0 ? clipped : 250));
      CHECK(program.answers[5].at.y == (axis == 1 ? clipped : 250));
      CHECK(program.answers[7].value == 1);  // the error is told once
      CHECK(program.app.mailbox().calibrated);
    }
  }
}

TEST_CASE("a switch in a move of either axis, at either end, ends the calibration") {
  for (const int axis : {0, 1}) {
    for (const bool high : {false, true}) {
      CAPTURE(axis, high);
      StepTableSetup setup = unlike();
      setup.margin = 100;
      Program program({kCal, {LarsonOp::kAbstbl, 250, 250}, kWait,
                       {LarsonOp::kAbstbl, axis == 1 ? 250 : high ? 450 : 50,
                        axis == 0 ? 250 : high ? 450 : 50},
                       kWait, {LarsonOp::kAbstbl, 1, 1}, kCal, {LarsonOp::kAbstbl, 1, 1}},
                      setup);
      program.run_to(4);  // then the move runs
      FakeTable::Axis& a = program.bus.axes[axis];
      (high ? a.high : a.low) = a.at + (high ? 5 : -5);
      program.run();
      CHECK(program.answers[4].value == 0);
      CHECK(program.answers[5].value == static_cast<int>(StepAnswer::kNotCalibrated));
    }
  }
}

TEST_CASE("MOV and BIS reach each of the four words, and that one alone") {
  for (std::int32_t word = 0; word < 4; ++word) {
    CAPTURE(word);
    Program program({{LarsonOp::kMov, word, 0x2151}, {LarsonOp::kBis, word, 0x0426}});
    program.run();
    for (std::int32_t k = 0; k < 4; ++k) {
      CAPTURE(k);
      const FakeTable::Axis& a = program.bus.axes[k / 2];
      const std::uint32_t rest = k % 2 == 0 ? map::kTerminal : 0;
      CHECK((k % 2 == 0 ? a.count : a.status) == (k == word ? 0x2577 : rest));
    }
  }
}

TEST_CASE("the rate code of a velocity is its nearest, and never above the most that is set") {
  const StepTable table(unlike());
  for (std::int32_t rate = -5; rate <= 4500; ++rate) {
    const std::int32_t asked = rate < 1 ? 1 : rate > 3000 ? 3000 : rate;
    const double nearest = 240'000.0 / asked;
    const auto ticks = static_cast<double>(4096 - table.code(rate));
    if (nearest >= 4096) {
      CHECK(ticks == 4096);
    } else if (ticks < nearest - 0.5 || ticks > nearest + 0.5) {
      CAPTURE(rate, ticks, nearest);
      CHECK((nearest < 80.5 && ticks == 80));
    }
  }
  StepTableSetup setup;
  for (setup.most_rate = 59; setup.most_rate <= 8000; ++setup.most_rate) {  // of table.most_rate
    const auto ticks = static_cast<std::int32_t>(4096 - StepTable(setup).code(9000));
    CAPTURE(setup.most_rate, ticks);
    REQUIRE(ticks * setup.most_rate >= 240'000);
    REQUIRE((ticks - 1) * setup.most_rate < 240'000);
  }
}
