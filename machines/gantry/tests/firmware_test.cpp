// SPDX-License-Identifier: Apache-2.0
//
// The firmware of the gantry track pass by pass, on a bus that only remembers: what it makes of
// positions, ticks and velocities, where homing and the way to the calibration run end.
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "machines/gantry/tests/fake_chip.hpp"
#include "models/plant/stripe_track.hpp"

using namespace trammel;
using namespace trammel::gantry_test;

namespace {

sw::GantryFailure failure(const Track& track) {
  return static_cast<sw::GantryFailure>(track.app.mailbox().failure);
}

// P with gain 1 and no least force: the force is the error, to the right at a goal of 0.
sw::GantrySetup as_it_is() {
  sw::GantrySetup setup;
  setup.position.gain = 1;
  setup.position.least = 0;
  return setup;
}

}  // namespace

TEST_CASE("gantry: the start sets the time of a pass, the observer and the interrupts") {
  sw::GantrySetup setup;
  setup.pass_clk = 123'456;
  FakeChip chip;
  sw::GantryApp app(setup);
  app.start(chip);
  CHECK(chip.words[regs::kPassPeriod] == 123'456);
  CHECK(chip.words[regs::kObserver] == 0x11);
  CHECK(chip.words[regs::kIrqEnable] ==
        (regs::kStatusPass | regs::kStatusFrame | regs::kStatusSample));
}

TEST_CASE("gantry: a count is the floor of the position, on either side of 0") {
  Track track;
  track.tell({{kValue, 21, 0}});
  for (const std::int32_t units : {-1, -512, -513, 0, 511, 512}) {
    track.chip.words[regs::kAngle] = regs::kAngleKnown;
    track.chip.words[regs::kPosition] = static_cast<std::uint32_t>(units);
    track.interrupt(regs::kStatusPass);
    CAPTURE(units);
    CHECK(track.app.mailbox().error == (units < -512 ? -2 : units < 0 ? -1 : units < 512 ? 0 : 1));
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
  CHECK(track.app.mailbox().velocity == 1250);
  track.chip.words[regs::kVelocity] = 0;
  track.tell({{kValue, 11, 0x01}, {kValue, 11, 0x11}});
  CHECK(track.app.mailbox().velocity == 0);
  track.pass(0);
  CHECK(track.app.mailbox().velocity == 0);
}

TEST_CASE("gantry: homing waits for a position that stands still, and then goes there") {
  sw::GantrySetup setup;
  setup.home = true;
  setup.home_ticks = 100;
  Track track(setup);
  track.tell({{kValue, 21, 200}});  // is dropped
  for (std::int32_t count = 20; count > -12; --count) track.pass(count, 90);
  CHECK_FALSE(track.app.mailbox().homed);
  track.pass(-11, 99);
  CHECK_FALSE(track.app.mailbox().homed);
  CHECK(track.tell({{kPoll, 0, 0}}).front().value == (1u << 24) - 2);  // -1.7 mm, from power-on
  track.pass(-11, 1);
  CHECK(track.force(1) == 0);     // the stop pushes back, and zero is where that ends
  track.pass(-10, 400);
  track.pass(-10, 460);
  CHECK_FALSE(track.app.mailbox().homed);
  track.pass(-10, 1);
  CHECK(track.app.mailbox().homed);
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kPosition);
  CHECK(track.app.mailbox().goal == 0);
  track.pass(-10);
  CHECK(track.app.mailbox().error == 0);
  CHECK(track.force(1) == 0);
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
      CHECK(track.app.mailbox().phase == sw::GantryPhase::kToFit);
    }
    track.pass(512 + side * 4, 4612);
    CHECK(track.app.mailbox().phase == sw::GantryPhase::kToFit);
    track.pass(512 + side * 4, 1);
    CHECK(track.app.mailbox().phase == sw::GantryPhase::kFitting);
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

TEST_CASE("gantry: a cascade asks for -512 times the error of both motors, on either side") {
  sw::GantrySetup setup;
  setup.cascade = true;
  for (const std::int32_t count : {-40, -1, 0, 1, 7, 40}) {
    Track track(setup);
    track.tell({{kValue, 21, 0}});
    track.pass(count);
    sw::VelocityPi::State state;
    const std::int32_t u = sw::VelocityPi::step({}, state, -512 * count, 0);
    CAPTURE(count);
    CHECK(track.force(1) == -u);
    CHECK(track.force(2) == -u);
  }
}

TEST_CASE("gantry: A and B may lie on a circle of 250 to 520 codes, and not beside it") {
  struct Case {
    int a, b;
    bool fine;
  };
  for (const auto& [a, b, fine] : {Case{150, 200, true}, {149, 200, false}, {150, 199, false},
                                   {312, 416, true}, {313, 416, false}, {312, 417, false}}) {
    for (const int signs : {0, 1, 2, 3}) {
      sw::GantrySetup setup = as_it_is();
      setup.watch_sensor = true;
      Track track(setup);
      const auto code = [](int off) { return static_cast<std::uint32_t>(512 + off); };
      track.chip.words[regs::kEncoderA] = 0x3FF'0000 | code((signs & 1) != 0 ? -a : a);
      track.chip.words[regs::kEncoderB] = 0x3FF'0000 | code((signs & 2) != 0 ? -b : b);
      track.tell({{kValue, 21, 0}});
      track.pass(50);
      CAPTURE(a, b, signs);
      CHECK(failure(track) == (fine ? sw::GantryFailure::kNone : sw::GantryFailure::kSensor));
      CHECK(track.force(1) == (fine ? 50 : 0));
      CHECK(track.force(2) == (fine ? 50 : 0));
      CHECK(track.app.mailbox().phase ==
            (fine ? sw::GantryPhase::kPosition : sw::GantryPhase::kIdle));
    }
  }
}

TEST_CASE("gantry: more than 160 counts of each motor and no motion for so long is a stall") {
  for (const std::int32_t sign : {-1, 1}) {
    for (const std::int32_t force : {160, 161}) {
      sw::GantrySetup setup = as_it_is();
      setup.stall_ticks = 100;
      Track track(setup);
      track.tell({{kValue, 21, 0}});
      track.pass(sign * (force - 1), 5000);
      track.pass(sign * force, 99);  // moved
      track.pass(sign * force, 99);
      CAPTURE(sign, force);
      CHECK(failure(track) == sw::GantryFailure::kNone);
      CHECK(track.force(1) == sign * force);
      track.pass(sign * force, 1);
      const bool stalled = force == 161;
      CHECK(failure(track) ==
            (stalled ? sw::GantryFailure::kStalled : sw::GantryFailure::kNone));
      CHECK(track.force(2) == (stalled ? 0 : sign * force));
      track.pass(0);  // what has failed stays off
      CHECK(track.app.mailbox().phase ==
            (stalled ? sw::GantryPhase::kIdle : sw::GantryPhase::kPosition));
      if (!stalled) continue;
      track.tell({{kValue, 21, 100}});
      track.pass(49);
      CHECK(track.force(1) == 0);
    }
  }
}

TEST_CASE("gantry: a cart that homing holds at its end, or a stall that is not watched, is none") {
  sw::GantrySetup setup = as_it_is();
  setup.home = true;
  setup.home_ticks = 1000;
  setup.stall_ticks = 100;
  Track homing(setup);
  for (int k = 0; k < 9; ++k) homing.pass(-11, 110);
  CHECK(failure(homing) == sw::GantryFailure::kNone);
  CHECK(homing.force(1) == 0x150);
  Track unwatched(as_it_is());
  unwatched.tell({{kValue, 21, 0}});
  for (int k = 0; k < 3; ++k) unwatched.pass(500, 100'000);
  CHECK(failure(unwatched) == sw::GantryFailure::kNone);
  CHECK(unwatched.force(1) == 500);
}

TEST_CASE("gantry: a calibration run asks for A and B in turn, seals what it found, then homes") {
  plant::StripeTrackConfig ideal;
  ideal.defect_units = {0, 0};
  const plant::StripeTrack stripes(ideal);
  for (const bool home : {false, true}) {
    for (const bool found : {false, true}) {
      sw::GantrySetup setup;
      setup.calibrate = true;
      setup.home = home;
      setup.home_ticks = 10;
      Track track(setup);
      for (int k = 0; home && k < 2; ++k) track.pass(0, 10);
      if (home) track.release(0);
      track.pass(512);
      track.pass(512, 5000);
      CAPTURE(home, found);
      REQUIRE(track.app.mailbox().phase == sw::GantryPhase::kFitting);
      CHECK(track.force(1) == -0x150);
      CHECK(track.force(2) == -0x150);
      track.tell({{kValue, 11, 0x01}, {kPoll, 1, 0}});  // the converter is the run's
      CHECK(track.chip.words[regs::kObserver] == 0);
      CHECK(track.app.mailbox().unknown == 1);
      sw::CalibrationFit fit;
      const std::uint32_t from = track.chip.words[regs::kTicks];
      bool of_a = true;
      for (std::uint32_t n = 1; track.app.mailbox().phase == sw::GantryPhase::kFitting; ++n) {
        REQUIRE(n < 100'000);
        const double x = found ? 0.1267 * n / 4612.0 : 0;
        track.chip.words[regs::kTicks] = from + n;
        track.chip.words[regs::kEncoderA] = static_cast<std::uint32_t>(stripes.code(0, x, 0));
        track.chip.words[regs::kEncoderB] = static_cast<std::uint32_t>(stripes.code(2, x, 0));
        const std::uint32_t wanted = of_a ? regs::kRequestA : regs::kRequestB;
        if (track.chip.words[regs::kRequest] != wanted) {
          FAIL("sample " << n << ": REQUEST is " << track.chip.words[regs::kRequest]
                         << ", wanted " << wanted);
        }
        fit.add(from + n, of_a, stripes.code(of_a ? 0 : 2, x, 0));
        of_a = !of_a;
        track.interrupt(regs::kStatusSample);
      }
      std::vector<std::uint32_t> sealed;
      sw::CalibrationWords words{};
      REQUIRE(fit.fit(words) == found);
      if (found) {
        sealed.push_back(1u << 16);
        for (const std::uint16_t word : words) sealed.push_back(2u << 16 | word);
        sealed.push_back(7u << 16);
      }
      CHECK(track.chip.calibrated == sealed);
      CHECK(track.app.mailbox().fitted == found);
      CHECK(track.chip.words[regs::kObserver] == 0x11);
      CHECK(failure(track) == (found ? sw::GantryFailure::kNone : sw::GantryFailure::kFitFailed));
      CHECK(track.app.mailbox().phase ==
            (home && found ? sw::GantryPhase::kHoming : sw::GantryPhase::kIdle));
      track.chip.words[regs::kRequest] = 0;
      track.interrupt(regs::kStatusSample);  // nobody asked for that
      CHECK(track.chip.sent.empty());
    }
  }
}
