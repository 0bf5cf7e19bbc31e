// SPDX-License-Identifier: Apache-2.0
//
// Frames that the firmware of the gantry track refuses: goals outside the track, frames without
// their checksum in the checked mode, answers for which there is no room.
#include <catch2/catch.hpp>
#include <vector>

#include "machines/gantry/tests/fake_chip.hpp"
#include "sw_nios/apps/gantry/protocol.hpp"

using namespace trammel;
using namespace trammel::gantry_test;

TEST_CASE("gantry: a goal outside the track is counted and nothing else; its key clips it") {
  sw::GantrySetup setup;
  for (const bool clips : {false, true}) {
    setup.clip_goals = clips;
    for (const std::uint32_t channel : {0u, 21u}) {  // the described output, and the listing's own
      Track track(setup);
      track.tell({{kValue, channel, 470}});
      CHECK(track.app.goal() == 3008);
      track.tell({{kValue, channel, 50}});
      for (const std::uint32_t outside : {471u, 512u + 50u, 0xFFFFFFFFu}) {
        track.tell({{kValue, channel, 50}});
        track.tell({{kValue, channel, outside}});
        CAPTURE(clips, channel, outside);
        CHECK(track.app.goal() == (clips ? 3008 : 320));
      }
      CHECK(track.app.refused() == (clips ? 0 : 3));
      CHECK(track.app.unknown() == 0);
    }
    Track track(setup);
    track.tell({{kValue, 22, 340'000}});
    CHECK(track.app.goal_velocity() == 170'000);
    track.tell({{kValue, 22, 0}});
    track.tell({{kValue, 22, 340'001}});
    CHECK(track.app.goal_velocity() == (clips ? 170'001 : -170'000));
    track.tell({{kValue, 21, 50}});
    track.tell({{kValue, 22, (1u << 23) + 170'000}});  // a stray byte in front of velocity 0
    CHECK(track.app.phase() == (clips ? sw::GantryPhase::kVelocity : sw::GantryPhase::kPosition));
    CHECK(track.app.refused() == (clips ? 0 : 2));
  }
}

TEST_CASE("gantry: in the checked mode a frame acts when the next one is its checksum") {
  sw::GantrySetup setup;
  setup.checked = true;
  Track track(setup);
  const auto sum = [](const Frame& f) {
    return Frame{kValue, 27, sw::gantry_channel::checksum_of({f.kind, f.channel, f.value})};
  };
  // CRC-16/CCITT-FALSE of 95 00 00 00 32.
  const Frame goal{kValue, 21, 50}, other{kValue, 21, 100}, poll{kPoll, 0, 0};
  CHECK(sum(goal).value == 0x02C0);
  track.tell({goal});
  CHECK(track.app.phase() == sw::GantryPhase::kIdle);
  track.tell({sum(goal)});
  CHECK(track.app.goal() == 320);
  CHECK(track.app.unchecked() == 0);
  track.tell({other, sum(goal)});     // another value came
  track.tell({{kValue, 21, 562}, sum(other)});
  track.tell({sum(goal)});            // nothing before it
  track.tell({other});                // its checksum is lost
  CHECK(track.app.goal() == 320);
  CHECK(track.app.unchecked() == 3);
  const Frame position{kValue, 0, 1u << 24};
  CHECK(track.tell({poll, sum(poll)}) == std::vector<Frame>{position, sum(position)});
  CHECK(track.app.unchecked() == 4);
  CHECK(track.app.refused() == 0);
}

TEST_CASE("gantry: an answer without room is counted, and in the checked mode never half sent") {
  sw::GantrySetup setup;
  for (const bool checked : {false, true}) {
    setup.checked = checked;
    Track track(setup);
    track.chip.words[regs::kSendState] = 1;
    const sw::gantry_channel::Frame poll{kPoll, 0, 0};
    std::vector<Frame> asked{{kPoll, 0, 0}};
    if (checked) asked.push_back({kValue, 27, sw::gantry_channel::checksum_of(poll)});
    CHECK(track.tell(asked).size() == (checked ? 0 : 1));
    CHECK(track.app.unsent() == (checked ? 1 : 0));
    track.chip.words[regs::kSendState] = 0;
    CHECK(track.tell(asked).empty());
    CHECK(track.app.unsent() == (checked ? 2 : 1));
  }
}
