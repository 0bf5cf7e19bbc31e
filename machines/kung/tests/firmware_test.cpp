// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <algorithm>

#include "machines/kung/tests/fake_chip.hpp"

using namespace trammel::sw;
using namespace trammel::test;

TEST_CASE("start keeps both axes off, their models in reset, and enables only the tick interrupt") {
  Machine m;
  m.app.start(m.chip);
  CHECK(m.app.mailbox().failure == 0);
  for (const Access& w : m.chip.writes()) {
    if (w.address == reg::kX + reg::kCtrl || w.address == reg::kY + reg::kCtrl) {
      CHECK((w.data & reg::kCtrlEnable) == 0);
      CHECK((w.data & reg::kCtrlResetModel) != 0);
    }
    if (w.address == reg::kIrqEn) CHECK((w.data & ~reg::kIrqEnTick) == 0);
  }
}

TEST_CASE("start unlocks first, resets the table, then commits the start point, then interrupts") {
  Machine m;
  m.app.start(m.chip);
  const auto& c = m.chip;
  CHECK(c.log[c.write_index(reg::kLock)].data == reg::kKeyUnlock);
  CHECK(c.write_index(reg::kLock) < c.write_index(reg::kDeadtimeMin));
  CHECK(c.write_index(reg::kDeadtimeMin) < c.write_index(reg::kX + reg::kDeadtime));
  CHECK(c.write_index(reg::kX + reg::kPosPreset) < c.write_index(reg::kX + reg::kCtrl, 1));
  const auto reset = c.log[c.write_index(reg::kY + reg::kCtrl, 1)];
  CHECK((reset.data & reg::kCtrlResetTable) != 0);
  CHECK(c.write_index(reg::kY + reg::kCtrl, 1) < c.write_index(reg::kX + reg::kPosCmd));
  CHECK(c.write_index(reg::kCommit) < c.write_index(reg::kIrqEn, 1));
}

TEST_CASE("start ends the stroke check of an earlier program before it moves limits and counts") {
  Machine m;
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    m.chip.registers[base + reg::kStrokeEn] = reg::kStrokeEnEnable;
  }
  m.app.start(m.chip);
  const auto& c = m.chip;
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    CAPTURE(base);
    CHECK(m.chip.registers[base + reg::kStrokeEn] == 0);
    CHECK(c.write_index(base + reg::kStrokeEn) < c.write_index(base + reg::kStrokeMin));
    CHECK(c.write_index(base + reg::kStrokeEn) < c.write_index(base + reg::kPosPreset));
  }
}

TEST_CASE("the first interrupt clears what is left over, then enables both axes; no point yet") {
  Machine m;
  m.chip.registers[reg::kFault] = reg::kFaultCodeEncoder;  // left over from power-up
  m.arm();
  CHECK(m.app.mailbox().failure == 0);
  CHECK(m.app.mailbox().point == 0);
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    CAPTURE(base);
    CHECK(m.chip.write_index(base + reg::kStatus) < m.chip.write_index(base + reg::kCtrl, 2));
  }
}

TEST_CASE("each interrupt acknowledges, reads the response, then writes X, Y and COMMIT") {
  Machine m;
  m.arm();
  const std::size_t before = m.chip.log.size();
  m.interrupt();
  CHECK(m.chip.log[before].address == reg::kIrqStat);
  CHECK_FALSE(m.chip.log[before].write);
  const auto writes = m.chip.writes(before);
  REQUIRE(writes.size() == 4);
  CHECK(writes[0].address == reg::kIrqStat);
  CHECK(writes[0].data == reg::kIrqStatTick);
  CHECK(writes[1].address == reg::kX + reg::kPosCmd);
  CHECK(writes[1].data == 50000);
  CHECK(writes[2].address == reg::kY + reg::kPosCmd);
  CHECK(writes[2].data == 70000);
  CHECK(writes[3].address == reg::kCommit);
  CHECK(writes[3].data == reg::kCommitTake);
  const auto at = [&](std::uint32_t address) {
    const auto begin = m.chip.log.begin() + static_cast<std::ptrdiff_t>(before);
    return std::find_if(begin, m.chip.log.end(),
                        [&](const Access& a) { return a.address == address; }) - begin;
  };
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    for (const std::uint32_t word : {reg::kStatus, reg::kPos, reg::kPosModel, reg::kIqCmd}) {
      INFO("register " << base + word << " is read before POS_CMD of X is written");
      CHECK(at(base + word) < at(reg::kX + reg::kPosCmd));
    }
  }
}

TEST_CASE("point 0 takes effect at the tick after its interrupt; all 629 points are committed") {
  Machine m;
  m.arm();
  m.interrupt();
  CHECK(m.app.mailbox().first_tick == m.chip.registers[reg::kTick] + 1);
  CHECK(m.app.mailbox().point == 1);
  const std::uint32_t first = m.app.mailbox().first_tick;
  int interrupts = 1;
  while (m.app.mailbox().done == 0 && interrupts < 1000) {
    m.interrupt();
    ++interrupts;
  }
  CHECK(interrupts == 629);
  CHECK(m.app.mailbox().point == m.app.points());
  CHECK(m.app.mailbox().first_tick == first);
  CHECK(m.chip.registers[reg::kX + reg::kPosCmd] == 50000);
  CHECK(m.chip.registers[reg::kY + reg::kPosCmd] == 70000);
}

TEST_CASE("after the last point the program holds it and keeps feeding the watchdog") {
  const Point list[] = {{100, 200}, {110, 210}};
  KungSetup setup;
  setup.path = Path::kPoints;
  setup.points = list;
  setup.n_points = 2;
  Machine m(setup);
  m.arm();
  m.interrupt();
  CHECK(m.app.mailbox().done == 0);
  m.interrupt();
  CHECK(m.app.mailbox().done == 1);
  const std::size_t before = m.chip.log.size();
  m.interrupt();
  const auto writes = m.chip.writes(before);
  CHECK(writes.back().address == reg::kCommit);
  CHECK(m.chip.registers[reg::kX + reg::kPosCmd] == 110);
  CHECK(m.app.mailbox().point == 2);
  CHECK(m.app.mailbox().failure == 0);
}

TEST_CASE("the square wave rests at low, steps at its first point and runs at every tick") {
  KungSetup setup;
  setup.path = Path::kSquare;
  setup.repeats = 8;
  setup.irq_period = 1;
  Machine m(setup);
  CHECK(Trajectory(setup).start() == Point{0, 0});
  CHECK(m.app.points() == 12000);
  m.arm();
  for (const std::uint32_t preset : {reg::kX + reg::kPosPreset, reg::kY + reg::kPosPreset}) {
    REQUIRE(m.chip.write_index(preset) < m.chip.log.size());
    CHECK(m.chip.registers[preset] == 0);
  }
  CHECK(m.chip.registers[reg::kIrqPeriod] == 1);
  CHECK(m.chip.registers[reg::kX + reg::kPosCmd] == 0);
  m.interrupt();
  CHECK(m.chip.registers[reg::kX + reg::kPosCmd] == 2000);
  for (int i = 1; i < 750; ++i) m.interrupt();
  CHECK(m.chip.registers[reg::kX + reg::kPosCmd] == 2000);
  m.interrupt();
  CHECK(m.chip.registers[reg::kX + reg::kPosCmd] == 0);
}

TEST_CASE("a sweep of current is written to IQ_MANUAL with open position loops, and feeds COMMIT") {
  KungSetup setup;
  setup.path = Path::kSweep;
  setup.sweep = {{60000, 55000}, {from_counts(100), from_counts(-50)}, 4, 0, 1, 4};
  setup.irq_period = 1;
  setup.current_command = true;
  Machine m(setup);
  m.arm();
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    CHECK(m.chip.registers[base + reg::kCtrl] == (reg::kCtrlEnable | reg::kCtrlCurrentLoop));
  }
  for (const std::int32_t sine : {0, 1, 0, -1, 0, 1, 0, -1, 0, 0}) {
    const std::size_t before = m.chip.log.size();
    m.interrupt();
    CHECK(static_cast<std::int32_t>(m.chip.registers[reg::kX + reg::kIqManual]) == 100 * sine);
    CHECK(static_cast<std::int32_t>(m.chip.registers[reg::kY + reg::kIqManual]) == -50 * sine);
    CHECK(m.chip.writes(before).back().address == reg::kCommit);
    CHECK(m.chip.registers[reg::kX + reg::kPosCmd] == 60000);
    CHECK(m.chip.registers[reg::kY + reg::kPosCmd] == 55000);
  }
  CHECK(m.app.mailbox().done == 1);
}

TEST_CASE("the log keeps the newest records") {
  Machine m;
  m.arm();
  m.interrupt();
  REQUIRE(m.app.log_size() == 1);
  const std::uint32_t first = m.app.log(0).tick;
  CHECK(first == m.chip.registers[reg::kTick]);
  for (int i = 0; i < 299; ++i) m.interrupt();
  REQUIRE(m.app.log_size() == KungApp::kLogSize);
  CHECK(m.app.log(0).tick == first + 4 * (300 - KungApp::kLogSize));
  CHECK(m.app.log(KungApp::kLogSize - 1).tick == first + 4 * 299);
}

TEST_CASE("a fault while running switches both axes off and is reported with its register") {
  for (const bool precision : {false, true}) {
    CAPTURE(precision);
    KungSetup setup;
    setup.precision.on = precision;
    Machine m(setup);
    m.arm();
    m.interrupt();
    m.chip.registers[reg::kFault] = 0x1200u | reg::kFaultAxis | reg::kFaultCodeStroke;
    m.chip.registers[reg::kIrqStat] |= reg::kIrqStatFault;
    m.app.isr(m.chip);
    CHECK(m.app.mailbox().failure != 0);
    CHECK(m.app.mailbox().done == 1);
    CHECK(failure(m) == Failure::kFault);
    CHECK((m.app.fault() & reg::kFaultCodeMask) == reg::kFaultCodeStroke);
    CHECK(still_on(m.chip) == "");
    const std::uint32_t written = m.app.mailbox().point;
    m.interrupt();
    CHECK(m.app.mailbox().point == written);
    CHECK(still_on(m.chip) == "");
  }
}

TEST_CASE("a fault that cannot be cleared keeps the axes off") {
  Machine m;
  m.chip.fault_stays = true;
  m.chip.registers[reg::kFault] = reg::kFaultCodeExternalTrip;
  m.arm();
  CHECK(failure(m) == Failure::kFault);
  CHECK(still_on(m.chip) == "");
}

TEST_CASE("a table reset that never ends is given up after a bounded number of polls") {
  Machine m;
  m.chip.busy_polls = 0xFFFFFFFFu;
  m.app.start(m.chip);
  CHECK(failure(m) == Failure::kBusy);
  CHECK(m.chip.log.size() < KungApp::kPollLimit + 200);
  CHECK(still_on(m.chip) == "");
}

TEST_CASE("the program refuses another chip and a lost preset") {
  Machine other;
  other.chip.registers[reg::kId] = 1;
  other.app.start(other.chip);
  CHECK(failure(other) == Failure::kWrongChip);
  CHECK(still_on(other.chip) == "");

  Machine lost;
  lost.chip.presets = false;
  lost.arm();
  CHECK(failure(lost) == Failure::kPreset);
  CHECK(still_on(lost.chip) == "");
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    CAPTURE(base);
    Machine one;
    one.app.start(one.chip);
    one.chip.registers[base + reg::kPos] += 1;
    one.interrupt();
    CHECK(failure(one) == Failure::kPreset);
    CHECK(still_on(one.chip) == "");
  }
}

TEST_CASE("a service that crosses a tick is reported as late") {
  Machine slow;
  slow.arm();
  slow.chip.ticks_per_commit = 1;
  slow.interrupt();
  CHECK(failure(slow) == Failure::kLate);
}

TEST_CASE("an interrupt without a cause does nothing") {
  Machine m;
  m.arm();
  m.interrupt();
  m.app.isr(m.chip);
  CHECK(m.app.mailbox().point == 1);
  CHECK(m.app.mailbox().failure == 0);
}
