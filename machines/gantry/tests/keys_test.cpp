// SPDX-License-Identifier: Apache-2.0
//
// What the options of the machine gantry may not be together, and frames that its firmware refuses:
// goals outside the track, frames without their checksum in the checked mode, answers for which
// there is no room.
#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "lab/layers.hpp"
#include "machines/gantry/machine_members.hpp"
#include "machines/gantry/tests/fake_chip.hpp"
#include "sw_nios/apps/gantry/protocol.hpp"
#include "tests/support/message.hpp"

using namespace trammel;
using namespace trammel::gantry_test;

TEST_CASE("gantry: two controls, or times, that exclude each other are refused") {
  const auto told = [](const std::string& toml) { return test::message_of<gantry::Options>(toml); };
  const std::string cascade = "[control]\ncascade = true\n", sum = "[position]\nsum = \"plain\"\n";
  CHECK(told(cascade + "compensate = true\n") == "");
  CHECK(told(sum) == "");
  CHECK_THAT(told("[position]\nbang_bang = true\n" + cascade),
             Catch::Contains("position.bang_bang: true, and control.cascade is true; permitted: "));
  CHECK_THAT(told(sum + cascade), Catch::Contains("position.sum: a sum, and control.cascade"));
  CHECK_THAT(told(sum + "bang_bang = true\n"),
             Catch::Contains("position.sum: a sum, and position.bang_bang"));
  CHECK_THAT(told("[control]\ncompensate = true\n"),
             Catch::Contains("control.compensate: true, and control.cascade is false; "));
  const auto assigned = [](const std::vector<std::string>& all) {
    return test::refusal_of([&all] {
      gantry::Options options;
      for (const std::string& one : all) lab::apply_assignment(options, one);
      lab::validate(options);
    });
  };
  const std::string both = "[run]\ntime_s = 1.5\nmax_s = 1\n";
  const std::string above = "run.time_s: 1.5 s is above run.max_s, 1 s; permitted: at most that";
  CHECK(told(both) == "some.toml:2: " + above);
  CHECK(told("[run]\ntime_s = 121\n") ==
        "some.toml:2: run.time_s: 121 s is above run.max_s, 120 s; permitted: at most that");
  CHECK(told("[run]\nmax_s = 1\n") == "");  // cuts the machine's own time
  CHECK(assigned({"run.time_s=1", "run.max_s=1"}) == "");
  CHECK(assigned({"run.max_s=1"}) == "");  // cuts the scenario's time
  CHECK(assigned({"run.time_s=1.5", "run.max_s=1"}) == above);
  CHECK_THAT(assigned({"run.time_s=120.5"}), Catch::StartsWith("run.time_s: 120.5 s is above"));
  // A file may have the time, -s or another file cut it, and the record repeats that.
  const auto layered = [](const std::string& first, const std::string& more, bool cut) {
    return test::refusal_of([&] {
      gantry::Options options;
      lab::apply_text(options, first, "first.toml", ".");
      lab::apply_text(options, more, "more.toml", ".");
      if (cut) lab::apply_assignment(options, "run.max_s=1");
      lab::validate(options);
      gantry::Options again;
      lab::apply_text(again, lab::run_toml(options), "run.toml", ".");
      lab::validate(again);
    });
  };
  const std::string time = "[run]\ntime_s = 1.5\n", most = "[run]\nmax_s = 1\n";
  CHECK(layered(time, "", true) == "");
  CHECK(layered(both, "", true) == "");
  CHECK(layered(time, most, false) == "");
  CHECK(layered(most, time, false) == "more.toml:2: " + above);
}

TEST_CASE("gantry: keys that choose what a run cannot have are refused, values are not") {
  const auto told = [](const std::string& toml) { return test::message_of<gantry::Options>(toml); };
  const std::string cascade = "[control]\ncascade = true\n";
  for (const char* const open : {"constant", "steps", "random"}) {
    const std::string force = fmt::format("[control]\nopen = \"{}\"\n", open);
    CAPTURE(open);
    CHECK(told(force) == "");
    CHECK(told(force + "[position]\ngain = 7\n[velocity]\nfeed_forward = false\n") == "");
    CHECK(told(force + "cascade = true\n") ==
          "control.open: a force without a controller, and control.cascade is true; permitted: "
          "none, or no controller");
    CHECK_THAT(told(force + "[position]\nbang_bang = true\n"),
               Catch::Contains("and position.bang_bang is true; permitted: "));
    CHECK_THAT(told(force + "[position]\nsum = \"cancel\"\n"),
               Catch::Contains("and position.sum is a sum; permitted: "));
    CHECK(told(force + "[run]\nreached_mm = 0.5\n") ==
          "run.reached_mm: 0.5 mm, and control.open drives the cart to no reference; permitted: "
          "below 0, or control.open=none");
    // It goes to the place where the calibration run begins.
    CHECK(told(force + "cascade = true\n[boot]\nhome = true\ncalibrate = true\n") == "");
  }
  CHECK(told(cascade + "[run]\nreached_mm = 0.5\n") == "");
  const std::string model = "model = \"0.5 1\"\n";
  CHECK(told("[velocity]\nfilter = \"kalman\"\n" + model) == "");
  for (const char* const filter : {"mean", "low_pass_1", "low_pass_2"}) {
    CHECK(told(fmt::format("[velocity]\nfilter = \"{}\"\n", filter) + model) ==
          "velocity.model: a model, and velocity.filter is not kalman, which alone has one; "
          "permitted: empty, or velocity.filter=kalman");
  }
}

TEST_CASE("gantry: forces that exclude each other are refused, each pair by its own keys") {
  const auto told = [](const std::string& toml) { return test::message_of<gantry::Options>(toml); };
  CHECK(told("") == "");
  CHECK(told("[axis]\ncoulomb_count = 90\nstiction_count = 90\n") == "");
  CHECK_THAT(told("[axis]\ncoulomb_count = 90.5\nstiction_count = 90\n"),
             Catch::EndsWith("axis.stiction_count: 90 is below axis.coulomb_count, 90.5; "
                             "permitted: at least that"));
  CHECK(told("[position]\nmin_force = 300\nmax_force = 300\n") == "");
  CHECK_THAT(told("[position]\nmin_force = 301\nmax_force = 300\n"),
             Catch::EndsWith("position.min_force: 301 is above position.max_force, 300; "
                             "permitted: at most that"));
  CHECK(told("[boot]\nhome = true\ncalibrate = true\n") == "");
  CHECK_THAT(told("[boot]\ncalibrate = true\n"),
             Catch::Contains("boot.calibrate: true, and boot.home is false; permitted: with "));
  CHECK_THAT(told("[host]\nsends = \"1:32=1\"\n"), Catch::Contains("host.sends: \"1:32=1\""));
}

TEST_CASE("gantry: a goal outside the track is counted and nothing else; its key clips it") {
  sw::GantrySetup setup;
  for (const bool clips : {false, true}) {
    setup.clip_goals = clips;
    for (const std::uint32_t channel : {0u, 21u}) {  // the described output, and the listing's own
      Track track(setup);
      track.tell({{kValue, channel, 470}});
      CHECK(track.app.mailbox().goal == 3008);
      track.tell({{kValue, channel, 50}});
      for (const std::uint32_t outside : {471u, 512u + 50u, 0xFFFFFFFFu}) {
        track.tell({{kValue, channel, 50}});
        track.tell({{kValue, channel, outside}});
        CAPTURE(clips, channel, outside);
        CHECK(track.app.mailbox().goal == (clips ? 3008 : 320));
      }
      CHECK(track.app.mailbox().refused == (clips ? 0 : 3));
      CHECK(track.app.mailbox().unknown == 0);
    }
    Track track(setup);
    track.tell({{kValue, 22, 340'000}});
    CHECK(track.app.mailbox().goal_velocity == 170'000);
    track.tell({{kValue, 22, 0}});
    track.tell({{kValue, 22, 340'001}});
    CHECK(track.app.mailbox().goal_velocity == (clips ? 170'001 : -170'000));
    track.tell({{kValue, 21, 50}});
    track.tell({{kValue, 22, (1u << 23) + 170'000}});  // a stray byte in front of velocity 0
    CHECK(track.app.mailbox().phase ==
          (clips ? sw::GantryPhase::kVelocity : sw::GantryPhase::kPosition));
    CHECK(track.app.mailbox().refused == (clips ? 0 : 2));
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
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kIdle);
  track.tell({sum(goal)});
  CHECK(track.app.mailbox().goal == 320);
  CHECK(track.app.mailbox().unchecked == 0);
  track.tell({other, sum(goal)});     // another value came
  track.tell({{kValue, 21, 562}, sum(other)});
  track.tell({sum(goal)});            // nothing before it
  track.tell({other});                // its checksum is lost
  CHECK(track.app.mailbox().goal == 320);
  CHECK(track.app.mailbox().unchecked == 3);
  const Frame position{kValue, 0, 1u << 24};
  CHECK(track.tell({poll, sum(poll)}) == std::vector<Frame>{position, sum(position)});
  CHECK(track.app.mailbox().unchecked == 4);
  CHECK(track.app.mailbox().refused == 0);
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
    CHECK(track.app.mailbox().unsent == (checked ? 1 : 0));
    track.chip.words[regs::kSendState] = 0;
    CHECK(track.tell(asked).empty());
    CHECK(track.app.mailbox().unsent == (checked ? 2 : 1));
  }
}
