// SPDX-License-Identifier: Apache-2.0
//
// The firmware of the gantry track pass by pass, on a bus that only remembers: what it makes of
// positions, ticks and velocities, where homing and the way to the calibration run end.
#include <catch2/catch.hpp>
#include <cstdint>

#include "machines/gantry/tests/fake_chip.hpp"

using namespace trammel;
using namespace trammel::gantry_test;

TEST_CASE("gantry: a count is the floor of the position, on either side of 0") {
  Track track;
  track.tell({{kValue, 21, 0}});
  for (const std::int32_t units : {-1, -512, -513, 0, 511, 512}) {
    track.chip.words[regs::kAngle] = regs::kAngleKnown;
    track.chip.words[regs::kPosition] = static_cast<std::uint32_t>(units);
    track.interrupt(regs::kStatusPass);
    CAPTURE(units);
    CHECK(track.app.error() == (units < -512 ? -2 : units < 0 ? -1 : units < 512 ? 0 : 1));
  }
}

TEST_CASE("gantry: a sum grows by the ticks between two passes, however many") {
  sw::GantrySetup setup;
  setup.position.sum = sw::PositionPi::Sum::kPlain;
  setup.position.gain = setup.position.time = setup.position.least = 0;
  Track track(setup);
  track.tell({{kValue, 21, 5}});  // 32 counts
  track.pass(31);
  CHECK(track.force(1) == 0);
  track.pass(31, 20);
  CHECK(track.force(1) == -20);
  track.pass(31, 3);
  CHECK(track.force(2) == -23);
  track.pass(31, 7, false);  // what was not seen is not counted
  track.pass(31, 2);
  CHECK(track.force(1) == -25);
}

TEST_CASE("gantry: both motors take their own force where backlash is compensated") {
  sw::GantrySetup setup;
  setup.cascade = setup.compensate = true;
  Track track(setup);
  track.tell({{kValue, 21, 5}});
  track.pass(32);
  CHECK(track.force(1) == 0x70);
  CHECK(track.force(2) == -0x70);
}

TEST_CASE("gantry: a velocity is filtered, and forgotten with the observer's position") {
  Track track;
  track.chip.words[regs::kVelocity] = 100'000;
  track.pass(0);
  CHECK(track.app.velocity() == 1250);
  track.chip.words[regs::kVelocity] = 0;
  track.tell({{kValue, 11, 0x01}, {kValue, 11, 0x11}});
  CHECK(track.app.velocity() == 0);
  track.pass(0);
  CHECK(track.app.velocity() == 0);
}

TEST_CASE("gantry: homing waits for a position that stands still, and then goes there") {
  sw::GantrySetup setup;
  setup.home = true;
  setup.home_ticks = 100;
  Track track(setup);
  track.tell({{kValue, 21, 200}});  // is dropped
  for (std::int32_t count = 20; count > -12; --count) track.pass(count, 90);
  CHECK_FALSE(track.app.homed());
  track.pass(-11, 99);
  CHECK_FALSE(track.app.homed());
  CHECK(track.tell({{kPoll, 0, 0}}).front().value == (1u << 24) - 2);  // -1.7 mm, from power-on
  track.pass(-11, 1);
  CHECK(track.app.homed());
  CHECK(track.app.phase() == sw::GantryPhase::kPosition);
  CHECK(track.app.goal() == 0);
  track.pass(-11);
  CHECK(track.app.error() == 0);
  CHECK(track.tell({{kPoll, 0, 0}}).front().value == 1u << 24);
}

TEST_CASE("gantry: the calibration run begins where the cart stands at 80 mm, from either side") {
  sw::GantrySetup setup;
  setup.calibrate = true;
  for (const std::int32_t side : {-1, 1}) {
    Track track(setup);
    for (const std::int32_t off : {400, 5}) {
      for (int k = 0; k < 10; ++k) track.pass(512 + side * off, 1000);
      CAPTURE(side, off);
      CHECK(track.app.phase() == sw::GantryPhase::kToFit);
    }
    track.pass(512 + side * 4, 4612);
    CHECK(track.app.phase() == sw::GantryPhase::kToFit);
    track.pass(512 + side * 4, 1);
    CHECK(track.app.phase() == sw::GantryPhase::kFitting);
  }
}

TEST_CASE("gantry: events are cleared as they were seen, and only those") {
  Track track;
  for (const std::uint32_t status :
       {regs::kStatusPass, regs::kStatusSample, regs::kStatusPass | regs::kStatusSample}) {
    track.interrupt(status);
    CHECK(track.chip.cleared == status);
  }
  track.chip.cleared = 0;
  track.interrupt(regs::kStatusFrame);
  CHECK(track.chip.cleared == 0);
}
