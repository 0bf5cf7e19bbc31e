// SPDX-License-Identifier: Apache-2.0
//
// What each channel of Serial2002 does and answers, and what is for no channel, on a bus that only
// remembers (Brochier 2006, 2.2.3; channels 11 to 13, 21, 22 and 31).
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "machines/gantry/tests/fake_chip.hpp"
#include "models/exact/bus/serial2002_rx.hpp"
#include "sw_nios/apps/gantry/protocol.hpp"
#include "tests/support/random.hpp"

using namespace trammel;
using namespace trammel::gantry_test;

TEST_CASE("gantry: at boot the reset message goes out, an interrupt of the timer is nothing") {
  FakeChip chip;
  sw::GantryApp app({});
  app.start(chip);
  CHECK(chip.sent == std::vector<Frame>{{kValue, 9, 42}});
  chip.words[sw::platform_map::kIrq] = sw::platform_map::kIrqTimer;
  chip.words[regs::kStatus] = regs::kStatusPass;
  app.isr(chip);
  CHECK(app.mailbox().point == 0);
}

TEST_CASE("gantry: what comes during the service of a pass is left in STATUS for the next one") {
  Track track;
  track.chip.later = regs::kStatusPass | regs::kStatusSample;
  track.pass(320);
  CHECK(track.app.mailbox().point == 1);
  CHECK(track.chip.words[regs::kStatus] == (regs::kStatusPass | regs::kStatusSample));
  track.app.isr(track.chip);
  CHECK(track.app.mailbox().point == 2);
  CHECK(track.chip.words[regs::kStatus] == 0);
}

TEST_CASE("gantry: polled bits are the temperatures, and other bits are unknown") {
  Track track;
  track.chip.words[regs::kOvertemp] = regs::kOvertempMotor2;
  CHECK(track.tell({{kPollBit, 0, 0}, {kPollBit, 1, 0}}) ==
        std::vector<Frame>{{kClearBit, 0, 0}, {kSetBit, 1, 0}});
  CHECK(track.app.mailbox().unknown == 0);
  CHECK(track.tell({{kPollBit, 2, 0}, {kClearBit, 0, 0}, {kSetBit, 1, 0}}).empty());
  CHECK(track.app.mailbox().unknown == 3);
}

TEST_CASE("gantry: polled position and velocity have their offsets, in either sense") {
  Track track;
  for (const std::int32_t count : {320, -32}) {  // 50 mm, -5 mm
    track.pass(count);
    track.chip.words[regs::kVelocity] = static_cast<std::uint32_t>(-count * 100);
    CAPTURE(count);
    CHECK(track.tell({{kPoll, 0, 0}, {kPoll, 4, 0}}) ==
          std::vector<Frame>{
              {kValue, 0, static_cast<std::uint32_t>((1 << 24) + count * 5 / 32)},
              {kValue, 4, static_cast<std::uint32_t>((1 << 22) - count * 100)}});
  }
}

TEST_CASE("gantry: each converter channel that is polled is asked for, and answered when done") {
  Track track;
  track.chip.words[regs::kEncoderA] = 0x0123'0045;
  track.chip.words[regs::kEncoderB] = 0x0267'0389;
  track.chip.words[regs::kCurrent] = 0x3A7;
  const std::vector<Frame> answers{{kValue, 1, 0x045}, {kValue, 2, 0x389}, {kValue, 3, 0xE9},
                                   {kValue, 5, 0x123}, {kValue, 6, 0x267}};
  const std::uint32_t bit_of[] = {1, 4, 64, 2, 8};
  for (std::size_t k = 0; k < answers.size(); ++k) {
    CAPTURE(answers[k].channel);
    CHECK(track.tell({{kPoll, answers[k].channel, 0}}).empty());
    CHECK(track.chip.words[regs::kRequest] == bit_of[k]);
    track.interrupt(regs::kStatusSample);  // another's
    CHECK(track.chip.sent.empty());
    track.chip.words[regs::kRequest] = 0;
    track.interrupt(regs::kStatusSample);
    CHECK(track.chip.sent == std::vector<Frame>{answers[k]});
    track.interrupt(regs::kStatusSample);
    CHECK(track.chip.sent.size() == 1);
  }
  for (const std::uint32_t channel : {7u, 8u, 10u, 30u}) track.tell({{kPoll, channel, 0}});
  CHECK(track.app.mailbox().unknown == 4);
}

TEST_CASE("gantry: channel 11 restarts the observer only where its mask changes") {
  Track track;
  track.tell({{kValue, 11, 0x11}});
  CHECK(track.chip.writes[regs::kObserver] == 0);
  track.tell({{kValue, 11, 0xFF01}});
  CHECK(track.chip.writes[regs::kObserver] == 1);
  CHECK(track.chip.words[regs::kObserver] == 0x01);
}

TEST_CASE("gantry: with the observer its position is gone: the motors rest until there is a goal") {
  Track track;
  track.tell({{kValue, 21, 305}});
  track.pass(100);
  CHECK(track.force(1) == -1023);
  track.pass(100, 9, false);  // it has not seen its first period
  CHECK(track.force(1) == 0);
  CHECK(track.force(2) == 0);
  track.pass(100);
  CHECK(track.force(1) == -1023);
  track.tell({{kValue, 11, 0x00}});
  CHECK(track.force(1) == 0);
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kIdle);
  track.tell({{kValue, 11, 0x11}});
  track.pass(3);
  CHECK(track.force(1) == 0);
  track.tell({{kValue, 21, 10}});
  track.pass(3);
  CHECK(track.force(2) < 0);
}

TEST_CASE("gantry: homing goes on where the observer was restarted") {
  sw::GantrySetup setup;
  setup.home = true;
  Track track(setup);
  track.pass(100);
  CHECK(track.force(1) == 0x150);
  track.tell({{kValue, 11, 0x01}});
  CHECK(track.force(1) == 0);
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kHoming);
  track.pass(7);
  CHECK(track.force(1) == 0x150);
  track.pass(7, setup.home_ticks);
  track.release(7);
  CHECK(track.app.mailbox().homed);
  CHECK(track.app.mailbox().zero == 7);
}

TEST_CASE("gantry: a restart of the observer after homing leaves neither zero nor homed") {
  sw::GantrySetup setup;
  setup.home = true;
  Track track(setup);
  track.pass(7);
  track.pass(7, setup.home_ticks);
  track.release(7);
  REQUIRE(track.app.mailbox().homed);
  track.tell({{kValue, 11, 0x01}});
  CHECK_FALSE(track.app.mailbox().homed);
  CHECK(track.app.mailbox().zero == 0);
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kIdle);
}

TEST_CASE("gantry: a goal ends a velocity and begins from rest, and the reverse; no run before") {
  using Phase = sw::GantryPhase;
  for (const std::uint32_t channel : {21u, 22u}) {
    const Phase own = channel == 21 ? Phase::kPosition : Phase::kVelocity;
    const Phase after[] = {own, Phase::kHoming, Phase::kToFit, Phase::kFitting, own, own};
    for (std::uint32_t k = 0; k < 6; ++k) {
      const auto from = static_cast<Phase>(k);
      sw::GantrySetup setup;
      setup.home = from == Phase::kHoming;
      setup.calibrate = from == Phase::kToFit || from == Phase::kFitting;
      Track track(setup);
      if (from == Phase::kFitting) {
        track.pass(512);
        track.pass(512, 5000);
      }
      if (from == Phase::kPosition) track.tell({{kValue, 21, 5}});
      if (from == Phase::kVelocity) track.tell({{kValue, 22, 170'000}});
      CAPTURE(channel, k);
      REQUIRE(track.app.mailbox().phase == from);
      track.tell({{kValue, channel, 10}});
      CHECK(track.app.mailbox().phase == after[k]);
    }
  }
}

TEST_CASE("gantry: channel 12 sets the slots of the observer or of the requester") {
  Track track;
  track.tell({{kValue, 12, 7 << 2 | 0}});
  CHECK(track.chip.words[regs::kSlots] == 0x0001'0007);
  track.tell({{kValue, 12, 254 << 2 | 2}});
  CHECK(track.chip.words[regs::kSlots] == 0x00FE'0007);
  track.tell({{kValue, 12, 255 << 2 | 2}, {kValue, 12, 1}, {kValue, 12, 3}});
  CHECK(track.chip.words[regs::kSlots] == 0x00FE'0007);
  CHECK(track.app.mailbox().unknown == 3);
}

TEST_CASE("gantry: channel 13 starts, sends and stores calibration data, and nothing else") {
  Track track;
  track.tell({{kValue, 13, 1 << 2}, {kValue, 13, 2 << 2 | 0xBEEFu << 6}, {kValue, 13, 7 << 2}});
  CHECK(track.chip.calibrated == std::vector<std::uint32_t>{0x1'0000, 0x2'BEEF, 0x7'0000});
  CHECK(track.app.mailbox().unknown == 0);
  track.tell({{kValue, 13, 3 << 2}});  // an address of the other bus: no error, no effect
  CHECK(track.app.mailbox().unknown == 0);
  track.tell({{kValue, 13, 0}, {kValue, 13, 4 << 2}, {kValue, 13, 15 << 2}});
  CHECK(track.chip.calibrated.size() == 3);
  CHECK(track.app.mailbox().unknown == 3);
}

TEST_CASE("gantry: a goal chooses its control; velocity has an offset") {
  Track track;
  track.tell({{kValue, 21, 305}});
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kPosition);
  CHECK(track.app.mailbox().goal == 1952);
  track.pass(0);
  CHECK(track.force(1) == -1023);  // toward larger positions
  CHECK(track.force(2) == -1023);
  track.tell({{kValue, 22, 170'000 + 50'000}});
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kVelocity);
  CHECK(track.app.mailbox().goal_velocity == 50'000);
  track.pass(0);
  CHECK(track.force(1) < 0);
  track.tell({{kValue, 22, 170'000 - 50'000}});
  CHECK(track.app.mailbox().goal_velocity == -50'000);
  track.pass(0);
  CHECK(track.force(2) > 0);
  track.tell({{kValue, 21, 0}});
  CHECK(track.app.mailbox().phase == sw::GantryPhase::kPosition);
  track.tell({{kValue, 23, 1}});
  CHECK(track.app.mailbox().unknown == 1);
}

TEST_CASE("gantry: while the angle is not known no motor is driven") {
  Track track;
  track.tell({{kValue, 21, 305}});
  track.pass(0, 9, false);
  CHECK(track.chip.writes[regs::kForce1] == 0);
  track.pass(0);
  CHECK(track.chip.writes[regs::kForce1] == 1);
}

TEST_CASE("gantry: the configuration is sent whole for each poll, whatever is asked meanwhile") {
  Track track;
  track.chip.words[regs::kSendState] = 5;
  std::vector<Frame> all = track.tell({{kPoll, 31, 0}, {kPoll, 31, 0}, {kPoll, 31, 0}});
  CHECK(all.size() == 15);  // five a frame, as there is room
  for (int k = 0; k < 20; ++k) {
    track.chip.sent.clear();
    track.pass(0);
    all.insert(all.end(), track.chip.sent.begin(), track.chip.sent.end());
  }
  constexpr std::uint32_t kWords = sw::gantry_channel::kConfigurationLength;
  REQUIRE(all.size() == 3 * kWords);
  for (std::size_t k = 0; k < all.size(); ++k) {
    CHECK(all[k] == Frame{kValue, 31, sw::gantry_channel::kConfigurationWords[k % kWords]});
  }
}

// Brochier 2006, appendix B.1: the reader takes mm and velocity as they come.
TEST_CASE("gantry: the stream is position, time and velocity, plain, and waits for room") {
  sw::GantrySetup setup;
  setup.stream = true;
  Track track(setup);
  track.chip.words[regs::kSendState] = 7;
  track.pass(64);
  CHECK(track.chip.sent.empty());
  track.chip.words[regs::kSendState] = 8;
  track.pass(64);
  CHECK(track.chip.sent == std::vector<Frame>{{kValue, 7, 10},
                                              {kValue, 30, track.chip.words[regs::kTicks]},
                                              {kValue, 29, 0}});
  track.chip.sent.clear();
  track.chip.words[regs::kVelocity] = static_cast<std::uint32_t>(-400);
  track.pass(-64);
  REQUIRE(track.chip.sent.size() == 3);
  CHECK(track.chip.sent[0] == Frame{kValue, 7, static_cast<std::uint32_t>(-10)});
  CHECK(track.chip.sent[2] == Frame{kValue, 29, static_cast<std::uint32_t>(-100)});  // the mean
}

TEST_CASE("gantry: of a million bytes each frame is answered, taken or counted, and none hangs") {
  Track track;
  test::Random random(28);
  exact::Serial2002Rx line;
  std::int64_t frames = 0, malformed = 0, ends = 0;
  const auto send = [&](std::uint32_t byte) {
    const auto out = line.step({true, random() % 1000 == 0, static_cast<std::uint8_t>(byte)});
    ends += byte < 0x80;
    malformed += out.malformed;
    if (!out.valid) return;
    ++frames;
    const exact::Frame& f = out.frame;
    const sw::GantryMailbox& mail = track.app.mailbox();
    const auto dropped = [&mail] { return mail.unknown + mail.refused; };
    const std::uint32_t before = dropped();
    track.tell({{f.kind, f.channel, f.value}});
    const bool counted = dropped() == before + 1;
    const std::uint32_t command = f.value >> 2 & 15, client = f.value & 3;
    bool known = false;
    std::size_t answers = 0;
    if (f.kind == kPollBit) {
      known = f.channel < 2;
      answers = known;
    } else if (f.kind == kPoll) {
      known = f.channel <= 6 || f.channel == 31;
      answers = f.channel == 0 || f.channel == 4 ? 1 : f.channel == 31 ? 23 : 0;
    } else if (f.kind == kValue) {
      known = f.channel == 11 || ((f.channel == 0 || f.channel == 21) && f.value <= 470) ||
              (f.channel == 22 && f.value <= 340'000) ||
              (f.channel == 12 && client % 2 == 0 && f.value >> 2 < 255) ||
              (f.channel == 13 && (command == 1 || command == 2 || command == 3 || command == 7));
    }
    const bool fine = counted != known && dropped() - before <= 1 &&
                      track.chip.sent.size() == answers && track.chip.waiting.empty();
    if (!fine) FAIL("kind " << f.kind << ", channel " << f.channel << ", value " << f.value);
  };
  for (int k = 0; k < 1'000'000; ++k) {
    send(random() % 4 == 0 ? random() & 0x7F : random() & 0xFF);
    if (k % 50 == 0) {  // what the host did meets what the track does
      track.chip.words[regs::kVelocity] = random() % 400'000 - 200'000;
      track.pass(static_cast<std::int32_t>(random() % 4000) - 500, 9, random() % 50 != 0);
      track.chip.words[regs::kRequest] = 0;
      track.interrupt(regs::kStatusSample);
      const std::int32_t one = track.force(1), two = track.force(2);
      if (one < -1023 || two < -1023) FAIL("forces of " << one << " and " << two);
    }
    if (k % 1000 == 0) {
      for (const std::uint32_t byte : {0x00u, 0xCCu, 0x35u}) {
        line.step({true, false, static_cast<std::uint8_t>(byte)});
      }
      REQUIRE(line.out().valid);
      track.tell({{line.out().frame.kind, line.out().frame.channel, line.out().frame.value}});
      REQUIRE(track.app.mailbox().goal == 1952);
    }
  }
  CHECK(frames + malformed >= ends);
  CHECK(frames > 300'000);
  CHECK(track.app.mailbox().failure == 0);
}
