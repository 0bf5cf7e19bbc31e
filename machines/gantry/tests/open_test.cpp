// SPDX-License-Identifier: Apache-2.0
//
// The firmware of the gantry track without controller and with one motor, pass by pass.
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "machines/gantry/tests/fake_chip.hpp"

using namespace trammel;
using namespace trammel::gantry_test;

namespace {

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

TEST_CASE("gantry: without controller the force is as it is asked for, whatever the host wants") {
  Track constant(open_setup(sw::OpenForce::kConstant, 3));
  CHECK(constant.app.phase() == sw::GantryPhase::kOpen);
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
  for (int k = 0; k < 60 && !track.app.homed(); ++k) track.pass(3);  // with 0.1 s of rest
  CHECK(track.app.homed());
  CHECK(track.app.phase() == sw::GantryPhase::kOpen);
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
