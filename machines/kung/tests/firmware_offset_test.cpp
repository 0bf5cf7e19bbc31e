// SPDX-License-Identifier: Apache-2.0
//
// The trajectory program measures the offsets of the current sensors before it starts the drives.
#include <catch2/catch.hpp>

#include <cstdint>

#include "machines/kung/tests/fake_chip.hpp"

using namespace trammel::sw;
using namespace trammel::test;

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
