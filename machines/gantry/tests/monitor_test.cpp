// SPDX-License-Identifier: Apache-2.0
//
// What the firmware watches where it is asked to: a force without motion, the circle of A and B.
#include <catch2/catch.hpp>
#include <cstdint>

#include "machines/gantry/tests/fake_chip.hpp"

using namespace trammel;
using namespace trammel::gantry_test;

namespace {

std::uint32_t failure(const Track& track) { return track.app.mailbox().failure; }
constexpr auto kStalled = static_cast<std::uint32_t>(sw::GantryFailure::kStalled);
constexpr auto kSensor = static_cast<std::uint32_t>(sw::GantryFailure::kSensor);

void codes(Track& track, std::uint32_t a, std::uint32_t b) {
  track.chip.words[regs::kEncoderA] = a;
  track.chip.words[regs::kEncoderB] = b;
}

}  // namespace

TEST_CASE("gantry: a force that moves nothing for so many ticks turns the motors off for good") {
  sw::GantrySetup setup;
  setup.stall_ticks = 100;
  Track track(setup);
  track.tell({{kValue, 21, 305}});
  for (int k = 0; k < 50; ++k) track.pass(k);  // it moves
  CHECK(failure(track) == 0);
  for (int k = 0; k < 11; ++k) track.pass(49);  // 99 ticks
  CHECK(failure(track) == 0);
  CHECK(track.force(1) == -1023);
  track.pass(49, 1);
  CHECK(failure(track) == kStalled);
  CHECK(track.force(1) == 0);
  CHECK(track.force(2) == 0);
  track.tell({{kValue, 21, 100}});
  track.pass(49);
  CHECK(track.force(1) == 0);
}

TEST_CASE("gantry: a force below 160 counts may hold the cart, and homing ends at a stop") {
  sw::GantrySetup setup;
  setup.stall_ticks = 100;
  for (const std::int32_t short_of : {53, 54}) {  // times K, 3
    Track track(setup);
    track.tell({{kValue, 21, 305}});
    for (int k = 0; k < 100; ++k) track.pass(1952 - short_of);
    CAPTURE(short_of);
    CHECK(track.force(1) == (short_of == 53 ? -159 : 0));
    CHECK(failure(track) == (short_of == 53 ? 0 : kStalled));
  }
  setup.home = true;
  Track track(setup);
  for (int k = 0; k < 100; ++k) track.pass(0);
  CHECK(failure(track) == 0);
  CHECK(track.force(1) == 0x150);
}

TEST_CASE("gantry: without its key a force that moves nothing goes on") {
  Track track;
  track.tell({{kValue, 21, 305}});
  for (int k = 0; k < 1000; ++k) track.pass(0);
  CHECK(failure(track) == 0);
  CHECK(track.force(1) == -1023);
}

TEST_CASE("gantry: codes of A and B off their circle turn the motors off, near it they do not") {
  sw::GantrySetup setup;
  setup.watch_sensor = true;
  struct Case {
    std::uint32_t a, b;
    bool fails;
  };
  for (const Case& one : {Case{912, 512, false}, Case{512, 912, false}, Case{795, 795, false},
                          Case{262, 512, false}, Case{261, 512, false}, Case{763, 512, false},
                          Case{761, 512, true}, Case{512, 512, true}, Case{512, 0, false},
                          Case{1023, 620, true}, Case{0, 0, true}}) {
    Track track(setup);
    codes(track, one.a, one.b);
    track.tell({{kValue, 21, 305}});
    track.pass(0);
    CAPTURE(one.a, one.b);
    CHECK(failure(track) == (one.fails ? kSensor : 0));
    CHECK(track.force(1) == (one.fails ? 0 : -1023));
  }
}
