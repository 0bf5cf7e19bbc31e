// SPDX-License-Identifier: Apache-2.0
//
// What the firmware refuses to run, and what it stops: at its limits and beyond, in either axis;
// and the offsets of the current sensors, which it measures before it starts the drives.
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "machines/kung/tests/fake_chip.hpp"

using namespace trammel::sw;
using namespace trammel::test;

TEST_CASE("every point of the path is held against the stroke, the first and the last one too") {
  for (const std::size_t outside : {0, 1, 2}) {
    CAPTURE(outside);
    std::vector<Point> points(3, Point{50000, 50000});
    KungSetup setup;
    setup.path = Path::kPoints;
    setup.points = points.data();
    setup.n_points = 3;
    Machine within(setup);
    within.app.start(within.chip);
    CHECK(failure(within) == Failure::kNone);
    points[outside] = {50000, 120001};
    Machine beyond(setup);
    beyond.app.start(beyond.chip);
    CHECK(failure(beyond) == Failure::kOutOfStroke);
    CHECK(still_on(beyond.chip) == "");
  }
}

TEST_CASE("a position beyond the limit from its model stops both drives, in each axis and sense") {
  KungSetup setup;
  setup.following_limit = 100;
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    for (const std::int32_t off : {100, -100, 101, -101}) {
      CAPTURE(base, off);
      Machine m(setup);
      m.arm();
      m.chip.registers[reg::kX + reg::kPosModel] = m.chip.registers[reg::kX + reg::kPos];
      m.chip.registers[reg::kY + reg::kPosModel] = m.chip.registers[reg::kY + reg::kPos];
      m.chip.registers[base + reg::kPos] += static_cast<std::uint32_t>(off);
      m.interrupt();
      const bool beyond = off > 100 || off < -100;
      CHECK(failure(m) == (beyond ? Failure::kFollowing : Failure::kNone));
      CHECK((still_on(m.chip) == "") == beyond);
    }
  }
}

TEST_CASE("a d current beyond its limit stops both drives, in each axis and sense") {
  KungSetup setup;
  setup.d_current_limit = 50;
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    for (const std::int32_t i_d : {50, -50, 51, -51}) {
      CAPTURE(base, i_d);
      Machine m(setup);
      m.arm();
      m.chip.registers[base + reg::kIdIq] = 700u << 16 | (static_cast<std::uint32_t>(i_d) & 0xFFFF);
      m.interrupt();
      const bool beyond = i_d > 50 || i_d < -50;
      CHECK(failure(m) == (beyond ? Failure::kDCurrent : Failure::kNone));
      CHECK((still_on(m.chip) == "") == beyond);
    }
  }
}

TEST_CASE("an axis that still shows that it is on is turned off again, so many times") {
  for (const std::uint32_t axis : {0, 1}) {
    for (const std::uint32_t lost : {0u, 1u, KungApp::kStopLimit, KungApp::kStopLimit + 1}) {
      CAPTURE(axis, lost);
      Machine m;
      m.arm();
      CHECK(still_on(m.chip) != "");
      m.chip.lost_stops[axis] = lost;
      m.app.stop(m.chip);
      CHECK((still_on(m.chip) == "") == (lost <= KungApp::kStopLimit));
      CHECK(m.chip.lost_stops[axis] == 0);
    }
  }
}

TEST_CASE("an interrupt that comes a tick late or early is told, at each period and across 2^32") {
  for (const std::uint32_t period : {0u, 1u, 2u, 32u}) {
    for (const int off : {-1, 0, 1}) {
      for (const std::uint32_t before : {1000u, 0xFFFF'FFFFu - period}) {
        CAPTURE(period, off, before);
        KungSetup setup;
        setup.irq_period = period;
        Machine m(setup);
        m.period = period == 0 ? 1 : period;  // each tick
        m.chip.registers[reg::kTick] = before;
        m.arm();
        m.interrupt();
        m.interrupt();
        REQUIRE(failure(m) == Failure::kNone);
        CHECK(m.app.mailbox().point == 2);
        m.period += static_cast<std::uint32_t>(off);
        m.interrupt();
        CHECK(failure(m) == (off == 0 ? Failure::kNone : Failure::kLate));
        CHECK((still_on(m.chip) == "") == (off != 0));
      }
    }
  }
}

TEST_CASE("the offsets of the sensors are the means of what they show, then the axes are enabled") {
  KungSetup setup;
  setup.offset_samples = 3;
  Machine m(setup);
  m.chip.registers[reg::kX + reg::kCurrentOffset] = 5;  // of an earlier program
  m.app.start(m.chip);
  CHECK(m.chip.registers[reg::kX + reg::kCurrentOffset] == 0);
  const auto show = [&m](std::int32_t xa, std::int32_t xb, std::int32_t ya, std::int32_t yb) {
    const auto both = [](std::int32_t a, std::int32_t b) {
      return (static_cast<std::uint32_t>(a) & 0xFFFFu) | static_cast<std::uint32_t>(b) << 16;
    };
    m.chip.registers[reg::kX + reg::kPhaseCurrents] = both(xa, xb);
    m.chip.registers[reg::kY + reg::kPhaseCurrents] = both(ya, yb);
    m.interrupt();
  };
  show(10, -10, 0, 256);
  show(10, -11, 1, 256);
  CHECK(m.chip.registers[reg::kX + reg::kCurrentOffset] == 0);
  show(12, -11, 0, 256);
  CHECK(m.chip.registers[reg::kX + reg::kCurrentOffset] == (0xFF5u << 16 | 11));  // -10.7, 10.7
  CHECK(m.chip.registers[reg::kY + reg::kCurrentOffset] == 256u << 16);           // 256, 0.33
  CHECK((m.chip.registers[reg::kX + reg::kCtrl] & reg::kCtrlEnable) == 0);
  m.interrupt();
  CHECK((m.chip.registers[reg::kX + reg::kCtrl] & reg::kCtrlEnable) != 0);
  CHECK(m.app.mailbox().failure == 0);
}

TEST_CASE("a sensor that shows more than an eighth of its range at rest keeps the axes off") {
  KungSetup setup;
  setup.offset_samples = 2;
  for (const std::uint32_t shown : {257u, 0xFEFFu, 257u << 16, 0xFEFFu << 16}) {
    for (const std::uint32_t base : {reg::kX, reg::kY}) {
      CAPTURE(shown, base);
      Machine m(setup);
      m.app.start(m.chip);
      m.chip.registers[base + reg::kPhaseCurrents] = shown;
      m.interrupt();
      CHECK(failure(m) == Failure::kNone);
      m.interrupt();
      CHECK(failure(m) == Failure::kSensor);
      CHECK(still_on(m.chip) == "");
    }
  }
}
