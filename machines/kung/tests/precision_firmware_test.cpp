// SPDX-License-Identifier: Apache-2.0
//
// The trajectory program with the precision controller, on registers that are plain memory.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "machines/kung/tests/fake_chip.hpp"
#include "sw_nios/apps/kung/identification.hpp"

using namespace trammel::sw;
using namespace trammel::test;

namespace {

constexpr std::uint32_t kAxes[] = {reg::kX, reg::kY};

KungSetup with_precision() {
  KungSetup s;
  s.precision.on = true;
  s.precision.axis[1].estimator.mass = 853034;
  s.precision.axis[1].estimator.mass_min = 328090;
  s.precision.axis[1].estimator.mass_max = 2187267;
  s.precision.axis[1].estimator.coulomb = 209978;
  return s;
}

std::int32_t control_point(const FakeChip& chip, std::uint32_t base, std::size_t from) {
  for (const auto& [at, data] : window(chip, base, from)) {
    if (at == 0) return static_cast<std::int32_t>(data);
  }
  FAIL("no control point was written");
  return 0;
}

}  // namespace

TEST_CASE("start chooses the controller in reset, then writes all words of both axes") {
  Machine m(with_precision());
  m.app.start(m.chip);
  REQUIRE(failure(m) == Failure::kNone);
  for (std::uint32_t a = 0; a < 2; ++a) {
    CAPTURE(a);
    const std::uint32_t base = kAxes[a];
    const std::size_t chosen = m.chip.write_index(base + reg::kCtrl, 1);
    CHECK(m.chip.log[chosen].data ==
          (reg::kCtrlPrecision | reg::kCtrlResetModel | reg::kCtrlResetTable));
    CHECK(chosen < m.chip.write_index(base + reg::kPrecAddr));
    CHECK(m.chip.write_index(base + reg::kPrecData) < m.chip.write_index(reg::kCommit));
    const std::uint32_t start = 256 * (a == 0 ? 50000u : 70000u);
    const auto g = [](std::int32_t mant, std::int32_t exp) { return gain_word({mant, exp}); };
    CHECK(window(m.chip, base, 0) ==
          std::vector<std::pair<std::uint32_t, std::uint32_t>>{
              {8, g(1401, -2)}, {9, g(1050, -6)}, {10, 0}, {11, g(1887, -14)}, {12, g(1376, -6)},
              {13, 0x11AF46}, {0, start}, {1, 0}, {2, a == 0 ? g(1687, -2) : g(1666, -1)},
              {3, a == 0 ? g(1243, 3) : g(1258, 2)}, {4, 0}, {5, g(1094, -2)},
              {6, a == 0 ? 4101u : 6562u}});
  }
}

TEST_CASE("the interrupt that arms leaves the reset and clears what the controller said") {
  Machine m(with_precision());
  m.arm();
  REQUIRE(failure(m) == Failure::kNone);
  for (const std::uint32_t base : kAxes) {
    CHECK(m.chip.registers[base + reg::kCtrl] ==
          (reg::kCtrlEnable | reg::kCtrlCurrentLoop | reg::kCtrlPositionLoop |
           reg::kCtrlPrecision));
    CHECK(m.chip.log[m.chip.write_index(base + reg::kStatus)].data == 0x7E);
  }
}

TEST_CASE("each interrupt reads the sums, then writes X, Y and COMMIT") {
  Machine m(with_precision());
  m.arm();
  const std::size_t before = m.chip.log.size();
  m.interrupt();
  REQUIRE(failure(m) == Failure::kNone);
  const auto writes = m.chip.writes(before);
  std::vector<std::uint32_t> wanted{reg::kIrqStat};
  for (const std::uint32_t base : kAxes) {
    wanted.push_back(base + reg::kPrecAddr);
    wanted.insert(wanted.end(), 7, base + reg::kPrecData);
  }
  wanted.push_back(reg::kCommit);
  std::vector<std::uint32_t> written;
  for (const Access& w : writes) written.push_back(w.address);
  CHECK(written == wanted);
  for (const std::uint32_t base : kAxes) {
    for (const std::uint32_t sum : {reg::kErrSum, reg::kIqSum}) {
      int reads = 0;
      for (std::size_t n = before; n < m.chip.log.size(); ++n) {
        reads += !m.chip.log[n].write && m.chip.log[n].address == base + sum ? 1 : 0;
      }
      CHECK(reads == 1);
    }
  }
}

TEST_CASE("144 points before the path identify, the full gains come at 118, then comes point 0") {
  Machine m(with_precision());
  m.arm();
  for (std::uint32_t n = 0; n < Identification::kPoints; ++n) {
    CAPTURE(n);
    const std::size_t before = m.chip.log.size();
    m.interrupt();
    REQUIRE(failure(m) == Failure::kNone);
    CHECK(m.app.mailbox().point == 0);
    const auto at = [](std::uint32_t k) { return Identification::offset(k, 40960); };
    const std::int32_t bend = at(n + 1) - 2 * at(n) + (n == 0 ? 0 : at(n - 1));
    const std::int32_t offset =
        at(n) - static_cast<std::int32_t>(std::floor((10923.0 * bend + 32768) / 65536));
    CHECK(control_point(m.chip, reg::kX, before) == 256 * 50000 + offset);
    const std::int32_t down = 256 * 70000 - control_point(m.chip, reg::kY, before);
    CHECK(std::abs(down - offset) <= 2);  // from above the middle, halves are rounded up
    std::size_t gains = 0;
    for (const auto& [word, data] : window(m.chip, reg::kX, before)) gains += word >= 8 ? 1 : 0;
    CHECK(gains == (n == 118 ? 5u : 0u));
    if (n == 118) {
      CHECK(window(m.chip, reg::kY, before).front() ==
            std::pair{8u, gain_word({1673, -1})});
    }
  }
  m.interrupt();
  CHECK(m.app.mailbox().point == 1);
  CHECK(m.app.mailbox().first_tick == m.chip.registers[reg::kTick] + 2);  // its knot
}

TEST_CASE("without identification point 0 comes first, with full gains") {
  KungSetup setup = with_precision();
  setup.precision.identify = false;
  Machine m(setup);
  m.app.start(m.chip);
  CHECK(window(m.chip, reg::kX, 0).front() == std::pair{8u, gain_word({1673, -1})});
  m.interrupt();
  m.interrupt();
  CHECK(m.app.mailbox().point == 1);
  CHECK(m.app.mailbox().first_tick == m.chip.registers[reg::kTick] + 2);  // its knot
}

TEST_CASE("all points are committed, then the last one is held") {
  KungSetup setup = with_precision();
  setup.path = Path::kLine;
  setup.line = {{from_counts(50'000), from_counts(60'000)}, {from_counts(50'030),
                from_counts(60'060)}, 3};
  Machine m(setup);
  m.arm();
  std::vector<std::int32_t> x;
  for (std::uint32_t n = 0; n < Identification::kPoints + 10; ++n) {
    const std::size_t before = m.chip.log.size();
    m.interrupt();
    if (n >= Identification::kPoints) x.push_back(control_point(m.chip, reg::kX, before) / 256);
  }
  REQUIRE(failure(m) == Failure::kNone);
  CHECK(m.app.mailbox().point == 4);
  CHECK(m.app.mailbox().done == 1);
  // The pre-filter leaves the middle as it is and goes beyond the ends by a sixth of the step.
  CHECK(x == std::vector<std::int32_t>{49998, 50010, 50020, 50031, 50030, 50030, 50030, 50030,
                                       50030, 50030});
  CHECK(m.app.log(m.app.log_size() - 1).x_cmd == 50030);
  CHECK(m.app.log(m.app.log_size() - 1).y_cmd == 60060);
}

TEST_CASE("an estimate changes the words of its own axis, and the ratio tells the change") {
  for (const std::uint32_t a : {0u, 1u}) {
    CAPTURE(a);
    Machine m(with_precision());
    m.arm();
    std::size_t before = 0;
    std::vector<std::uint32_t> masses{m.chip.registers[0]};
    bool told = false;
    std::uint32_t km = 0;
    for (std::uint32_t n = 0; n < 60; ++n) {
      before = m.chip.log.size();
      m.chip.registers[kAxes[a] + reg::kIqSum] = n % 2 == 0 ? 3000u : 0u - 2000u;
      m.interrupt();
      const auto words = window(m.chip, kAxes[a], before);
      const auto other = window(m.chip, kAxes[1 - a], before);
      CHECK(other[2].second != 0);
      if (km != 0 && words[2].second != km) {
        told = true;
        CHECK(words[4].second != 0);
      } else {
        CHECK(words[4].second == 0);
      }
      km = words[2].second;
    }
    CHECK(told);
  }
}

TEST_CASE("with estimates that are kept no word changes on the path") {
  KungSetup setup = with_precision();
  setup.precision.identify = false;
  setup.precision.adapt = false;
  Machine m(setup);
  m.arm();
  for (std::uint32_t n = 0; n < 200; ++n) {
    m.chip.registers[reg::kX + reg::kIqSum] = 100 * n;
    const std::size_t before = m.chip.log.size();
    m.interrupt();
    CHECK(window(m.chip, reg::kX, before)[2].second == gain_word({1687, -2}));
  }
  CHECK(m.app.mailbox().estimator(0).theta()[Estimator::kMass] == 431985);
}

TEST_CASE("a knot without a COMMIT in time is reported as late, of either axis") {
  for (const std::uint32_t a : {0u, 1u}) {
    Machine m(with_precision());
    m.arm();
    m.interrupt();
    m.chip.shown_status[a] = reg::kStatusUnderrun;
    m.interrupt();
    CHECK(failure(m) == Failure::kLate);
    CHECK(still_on(m.chip) == "");
  }
  Machine clipped(with_precision());
  clipped.arm();
  clipped.chip.shown_status = {reg::kStatusClipped, reg::kStatusClipped};
  clipped.interrupt();
  CHECK(failure(clipped) == Failure::kNone);
}

TEST_CASE("the first COMMIT waits for the next tick and must come before the one after it") {
  Machine m(with_precision());
  m.arm();
  const std::size_t before = m.chip.log.size();
  m.interrupt();
  REQUIRE(failure(m) == Failure::kNone);
  const auto reads = [&](std::size_t from) {
    return std::count_if(m.chip.log.begin() + static_cast<std::ptrdiff_t>(from), m.chip.log.end(),
                         [](const Access& a) { return !a.write && a.address == reg::kTick; });
  };
  CHECK(reads(before) == 5);  // its own, three polls, one behind the COMMIT
  const std::size_t second = m.chip.log.size();
  m.interrupt();
  CHECK(reads(second) == 1);

  Machine late(with_precision());
  late.arm();
  late.chip.ticks_per_commit = 1;
  late.interrupt();
  CHECK(failure(late) == Failure::kLate);

  Machine dead(with_precision());
  dead.chip.tick_at_read = 0;
  dead.arm();
  dead.interrupt();
  CHECK(failure(dead) == Failure::kLate);
  CHECK(dead.chip.log.size() < KungApp::kPollLimit + 300);
}

TEST_CASE("an error beyond the limit of the firmware turns the drives off") {
  for (const std::uint32_t base : kAxes) {
    for (const std::int32_t counts : {-101, -100, 100, 101}) {
      KungSetup setup = with_precision();
      setup.following_limit = 100;
      Machine m(setup);
      m.arm();
      m.chip.registers[base + reg::kPos] = 7;
      m.chip.registers[base + reg::kPrecErr] = static_cast<std::uint32_t>(256 * counts);
      m.interrupt();
      CAPTURE(base, counts);
      CHECK(failure(m) == (std::abs(counts) > 100 ? Failure::kFollowing : Failure::kNone));
    }
  }
}

TEST_CASE("a stroke without room for the identification move of an axis is refused, either way") {
  for (const std::uint32_t a : {0u, 1u}) {
    for (const bool down : {false, true}) {  // the other axis moves up
      for (const bool room : {false, true}) {
        CAPTURE(a, down, room);
        KungSetup setup = with_precision();
        setup.path = Path::kLine;
        setup.line = {{from_counts(50'000), from_counts(50'000)}, {from_counts(50'010),
                      from_counts(50'010)}, 3};
        setup.axis[a].stroke_min = !down ? 49'990 : room ? 49'840 : 49'841;
        setup.axis[a].stroke_max = down ? 50'010 : room ? 50'160 : 50'159;
        Machine m(setup);
        m.app.start(m.chip);
        CHECK(failure(m) == (room ? Failure::kNone : Failure::kOutOfStroke));
      }
    }
  }
}

TEST_CASE("each axis has its own gains, to identify with and from point 118 on") {
  for (const bool identify : {false, true}) {
    KungSetup setup = with_precision();
    setup.precision.identify = identify;
    for (std::uint32_t a = 0; a < 2; ++a) {
      for (std::uint32_t k = 0; k < 5; ++k) {
        setup.precision.axis[a].full[k] = {static_cast<std::int32_t>(1100 + 100 * a + k), -1};
        setup.precision.axis[a].soft[k] = {static_cast<std::int32_t>(1500 + 100 * a + k), -2};
      }
    }
    Machine m(setup);
    const auto check = [&](std::size_t from, bool soft) {
      for (std::uint32_t a = 0; a < 2; ++a) {
        const PrecisionAxisSetup& own = setup.precision.axis[a];
        const auto words = window(m.chip, a == 0 ? reg::kX : reg::kY, from);
        for (std::uint32_t k = 0; k < 5; ++k) {
          CAPTURE(identify, a, k);
          CHECK(words[k] == std::pair{8 + k, gain_word((soft ? own.soft : own.full)[k])});
        }
      }
    };
    m.arm();
    check(0, identify);
    if (!identify) continue;
    for (std::uint32_t n = 0; n < Identification::kFull; ++n) m.interrupt();
    const std::size_t before = m.chip.log.size();
    m.interrupt();
    check(before, false);
  }
}

TEST_CASE("what was learned in a lap is in the control points of the next") {
  for (const std::uint32_t ahead : {0u, Identification::kPoints}) {
    KungSetup setup = with_precision();
    setup.repeats = 2;
    setup.precision.identify = ahead != 0;
    setup.precision.learn = true;
    Corrections corrections;
    setup.precision.corrections = &corrections;
    Machine m(setup);
    m.arm();
    m.chip.registers[reg::kX + reg::kErrSum] = 32 * 100;
    for (std::uint32_t n = 0; n < ahead; ++n) m.interrupt();
    std::vector<std::int32_t> first;
    for (std::uint32_t n = 0; n < 2 * 628; ++n) {
      const std::size_t before = m.chip.log.size();
      m.interrupt();
      const std::int32_t x = control_point(m.chip, reg::kX, before);
      CAPTURE(ahead, n);
      if (n < 628) {
        first.push_back(x);
      } else if (n == 628 + 100 || n == 628 + 580) {
        CHECK(x - first[n - 628] == Approx(80).margin(1));  // 0.8 of it
      } else if (n == 628 + 4) {
        CHECK(x == first[4]);
      }
      CHECK(corrections.of[1][100] == 0);
    }
    for (std::uint32_t n = 0; n < 200; ++n) {  // held behind the last lap, where there are none
      const std::size_t before = m.chip.log.size();
      m.interrupt();
      CAPTURE(ahead, n);
      if (n > 5) CHECK(control_point(m.chip, reg::kX, before) == 256 * 50'000);
    }
  }
}
