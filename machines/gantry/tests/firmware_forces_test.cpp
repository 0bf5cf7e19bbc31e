// SPDX-License-Identifier: Apache-2.0
//
// What the firmware of the gantry track does with its motors: forces of homing and calibration,
// and runs without controller or with one motor.
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "machines/gantry/tests/fake_chip.hpp"

using namespace trammel;
using namespace trammel::gantry_test;

namespace {

void check_forces(Track& track, std::int32_t force) {
  CHECK(track.force(1) == force);
  CHECK(track.force(2) == force);
}

sw::GantrySetup open_setup(sw::OpenForce kind, std::uint32_t passes) {
  sw::GantrySetup setup;
  setup.open = kind;
  setup.open_force = 77;
  setup.open_passes = passes;
  return setup;
}

std::vector<std::int32_t> forces(Track& track, int passes) {
  std::vector<std::int32_t> all;
  for (int k = 0; k < passes; ++k) {
    track.pass(k);
    CHECK(track.force(1) == track.force(2));
    all.push_back(track.force(1));
  }
  return all;
}

}  // namespace

TEST_CASE("gantry: homing and the calibration run take their own forces, in opposite senses") {
  sw::GantrySetup setup;
  setup.home = setup.calibrate = true;
  setup.home_force = 201;
  setup.home_ticks = 100;
  setup.fit_force = 302;
  Track track(setup);
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kHoming);
  track.pass(7);
  check_forces(track, 201);
  track.pass(6);
  check_forces(track, 201);
  track.pass(6, 100);
  check_forces(track, 0);
  track.release(6);
  CHECK(track.app.mailbox().homed);
  CHECK(track.app.mailbox().zero == 6);
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kToFit);
  CHECK_FALSE(track.app.mailbox().fitted);
  track.pass(6);
  CHECK(track.app.mailbox().goal == 512);  // 80 mm of 5/32 mm
  CHECK(track.app.mailbox().error == -512);
  CHECK(track.force(1) < 0);
  track.pass(6 + 512);
  track.pass(6 + 512, 4613);
  REQUIRE(track.app.mailbox().phase == sw::GantryPhase::kFitting);
  check_forces(track, -302);
  CHECK(track.chip.words[regs::kObserver] == 0);
  CHECK(track.chip.words[regs::kRequest] == regs::kRequestA);
  const std::uint32_t passes = track.app.mailbox().point;
  track.pass(6 + 700);  // of the run no pass takes the force away
  check_forces(track, -302);
  CHECK(track.app.mailbox().point == passes + 1);
}

TEST_CASE("gantry: an axis that only calibrates starts to the fit, and one of neither rests") {
  sw::GantrySetup setup;
  Track idle(setup);
  CHECK(idle.app.mailbox().phase == sw::GantryPhase::kIdle);
  idle.pass(300);
  CHECK(idle.chip.writes[regs::kForce1] == 0);
  CHECK(idle.chip.writes[regs::kForce2] == 0);
  setup.calibrate = true;
  Track fits(setup);
  CHECK(fits.app.mailbox().phase == sw::GantryPhase::kToFit);
  setup.home = true;
  Track homes(setup);
  CHECK(homes.app.mailbox().phase == sw::GantryPhase::kHoming);
}

TEST_CASE("gantry: the time at rest before the run counts from when the cart came within 4") {
  sw::GantrySetup setup;
  setup.calibrate = true;
  Track track(setup);
  track.pass(512);
  track.pass(512, 4600);
  track.pass(512 + 5, 100);  // away again
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kToFit);
  track.pass(512 - 4, 4612);
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kToFit);
  track.pass(512 + 4, 1);
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kFitting);
}

TEST_CASE("gantry: homing counts its rest anew at each count that the cart moves, either way") {
  sw::GantrySetup setup;
  setup.home = true;
  setup.home_ticks = 50;
  Track track(setup);
  track.pass(3);
  for (const std::int32_t count : {3, 2, 3, 3, 2}) track.pass(count, 49 - 24 * (count == 3));
  CHECK_FALSE(track.app.mailbox().homed);
  track.pass(2, 49);
  CHECK_FALSE(track.app.mailbox().homed);
  track.pass(2, 1);
  track.release(2);
  CHECK(track.app.mailbox().homed);
  CHECK(track.app.mailbox().zero == 2);
}

TEST_CASE("gantry: homing ends 0.1 s later where the position jitters by a count, never by two") {
  for (const std::int32_t jitter : {1, 2}) {
    sw::GantrySetup setup;
    setup.home = true;
    setup.home_ticks = 1000;
    Track track(setup);
    track.pass(9);
    for (int k = 0; k < 14; ++k) track.pass(k % 2 == 0 ? 3 : 3 + jitter, 100);
    CHECK(track.force(1) == 0x150);
    for (int k = 0; k < 8; ++k) track.pass(k % 2 == 0 ? 3 : 3 + jitter, 100);
    CHECK(track.force(1) == (jitter == 1 ? 0 : 0x150));
    for (int k = 0; k < 8; ++k) track.pass(k % 2 == 0 ? 3 : 3 + jitter, 100);
    CHECK(track.app.mailbox().homed == (jitter == 1));
  }
}

TEST_CASE("gantry: rest is counted from the first pass that has a position, however late it is") {
  sw::GantrySetup setup;
  setup.home = true;
  setup.home_ticks = 100;
  Track homes(setup);
  homes.pass(0, 1'000'000, false);
  homes.pass(7, 9);
  CHECK_FALSE(homes.app.mailbox().homed);
  check_forces(homes, 0x150);
  homes.pass(7, 99);
  CHECK_FALSE(homes.app.mailbox().homed);
  homes.pass(7, 1);
  homes.release(7);
  CHECK(homes.app.mailbox().homed);
  setup.home = false;
  setup.calibrate = true;
  Track fits(setup);
  fits.pass(0, 1'000'000, false);
  fits.pass(512, 9);
  CHECK(fits.app.mailbox().phase == sw::GantryPhase::kToFit);
  fits.pass(512, 4612);
  CHECK(fits.app.mailbox().phase == sw::GantryPhase::kToFit);
  fits.pass(512, 1);
  CHECK(fits.app.mailbox().phase == sw::GantryPhase::kFitting);
}

TEST_CASE("gantry: without controller the force is as it is asked for, whatever the host wants") {
  Track constant(open_setup(sw::OpenForce::kConstant, 3));
  CHECK(constant.app.mailbox().phase == sw::GantryPhase::kOpen);
  constant.tell({{kValue, 21, 5}});
  CHECK(forces(constant, 4) == std::vector<std::int32_t>{77, 77, 77, 77});
  constant.tell({{kValue, 22, 171000}});
  CHECK(forces(constant, 1) == std::vector<std::int32_t>{77});
  Track steps(open_setup(sw::OpenForce::kSteps, 2));
  CHECK(forces(steps, 6) == std::vector<std::int32_t>{77, 77, -77, -77, 77, 77});
}

TEST_CASE("gantry: a random force is 127 bits that have every word but 0, then their inverse") {
  constexpr int kTurn = 127;
  Track track(open_setup(sw::OpenForce::kRandom, 3));
  const auto all = forces(track, 3 * 4 * kTurn);
  std::vector<int> bits;
  for (std::size_t k = 0; k < all.size(); k += 3) {
    CHECK(all[k] == all[k + 1]);
    CHECK(all[k] == all[k + 2]);
    bits.push_back(all[k] == 77 ? 1 : 0);
  }
  std::vector<bool> words(128);
  for (std::size_t k = 0; k < kTurn; ++k) {
    int word = 0;
    for (std::size_t n = 0; n < 7; ++n) word = word << 1 | bits[(k + n) % kTurn];
    words[static_cast<std::size_t>(word)] = true;
    CHECK(bits[k + kTurn] == 1 - bits[k]);
    CHECK(bits[k + 2 * kTurn] == bits[k]);
  }
  int seen = 0;
  for (const bool word : words) seen += word ? 1 : 0;
  CHECK(seen == kTurn);
  CHECK_FALSE(words[0]);
}

TEST_CASE("gantry: homing ends in the run without controller") {
  sw::GantrySetup setup = open_setup(sw::OpenForce::kConstant, 1);
  setup.home = true;
  setup.home_ticks = 10;
  Track track(setup);
  for (int k = 0; k < 60 && !track.app.mailbox().homed; ++k) track.pass(3);  // with 0.1 s of rest
  CHECK(track.app.mailbox().homed);
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kOpen);
  track.pass(3);
  CHECK(track.force(1) == 77);
}

TEST_CASE("gantry: of two motors the one that is asked for is driven") {
  for (const auto motors : {sw::Motors::kFirst, sw::Motors::kSecond}) {
    sw::GantrySetup setup = open_setup(sw::OpenForce::kConstant, 1);
    setup.motors = motors;
    Track track(setup);
    track.pass(0);
    CHECK(track.force(1) == (motors == sw::Motors::kFirst ? 77 : 0));
    CHECK(track.force(2) == (motors == sw::Motors::kSecond ? 77 : 0));
  }
}
