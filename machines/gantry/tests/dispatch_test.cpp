// SPDX-License-Identifier: Apache-2.0
//
// What each channel of Serial2002 does and answers, and what is for no channel, on a bus that only
// remembers (Brochier 2006, 2.2.3; channels 11 to 13, 21, 22 and 31).
#include <catch2/catch.hpp>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "rtl/chips/generated/gantry_tau_regs.hpp"
#include "sw_nios/apps/gantry/gantry.hpp"
#include "sw_nios/apps/gantry/gantry_map.hpp"
#include "sw_nios/apps/gantry/protocol.hpp"

using namespace trammel;
namespace regs = gantry_tau_regs;

namespace {

struct Frame {
  std::uint32_t kind, channel, value;
  bool operator==(const Frame& o) const {
    return kind == o.kind && channel == o.channel && value == o.value;
  }
};
constexpr std::uint32_t kClearBit = 0, kSetBit = 1, kPollBit = 2, kPoll = 3, kValue = 4;

std::ostream& operator<<(std::ostream& to, const Frame& f) {
  return to << "kind " << f.kind << ", channel " << f.channel << ", value " << f.value;
}

// The chip as its firmware sees it: frames that wait, frames sent, and words.
struct FakeChip final : sw::Bus {
  std::map<std::uint32_t, std::uint32_t> words{{regs::kSendState, 40}, {regs::kSlots, 0x1'0002}};
  std::deque<Frame> waiting;
  std::vector<Frame> sent;
  std::vector<std::uint32_t> calibrated;
  std::map<std::uint32_t, int> writes;

  std::uint32_t read(std::uint32_t address) override {
    if (address == regs::kReceive) {
      if (waiting.empty()) return 0;
      return regs::kReceiveWaits | waiting.front().kind << 8 | waiting.front().channel;
    }
    if (address == regs::kReceiveValue) return waiting.front().value;
    return words[address];
  }
  void write(std::uint32_t address, std::uint32_t data) override {
    ++writes[address];
    if (address == regs::kReceive) {
      REQUIRE(data == regs::kReceiveTake);
      waiting.pop_front();
    } else if (address == regs::kSend) {
      const std::uint32_t kind = data >> 8;
      sent.push_back({kind, data & 31, kind == kValue ? words[regs::kSendValue] : 0});
    } else if (address == regs::kCalibrate) {
      calibrated.push_back(data);
    } else if (address != regs::kStatus) {  // its bits are cleared by writing
      words[address] = data;
    }
  }
};

struct Track {
  FakeChip chip;
  sw::GantryApp app;

  explicit Track(const sw::GantrySetup& setup = {}) : app(setup) {
    app.start(chip);
    chip.sent.clear();
    chip.writes.clear();
  }
  void interrupt(std::uint32_t status) {
    chip.words[sw::gantry_map::kIrq] = sw::gantry_map::kIrqChip;
    chip.words[regs::kStatus] = status;
    app.isr(chip);
  }
  std::vector<Frame> tell(std::vector<Frame> frames) {
    chip.sent.clear();
    chip.waiting.assign(frames.begin(), frames.end());
    interrupt(regs::kStatusFrame);
    return chip.sent;
  }
  // A control pass with the cart there [count], so many ticks behind the last one.
  void pass(std::int32_t count, std::uint32_t ticks = 9, bool known = true) {
    chip.words[regs::kTicks] += ticks;
    chip.words[regs::kAngle] = known ? regs::kAngleKnown : 0;
    chip.words[regs::kPosition] = static_cast<std::uint32_t>(count * 512);
    interrupt(regs::kStatusPass);
  }
  std::int32_t force(std::uint32_t motor) {
    const std::uint32_t bits = chip.words[motor == 1 ? regs::kForce1 : regs::kForce2];
    return static_cast<std::int32_t>(bits ^ 0x400) - 0x400;
  }
};

}  // namespace

TEST_CASE("gantry: at boot the reset message goes out, an interrupt of the timer is nothing") {
  FakeChip chip;
  sw::GantryApp app({});
  app.start(chip);
  CHECK(chip.sent == std::vector<Frame>{{kValue, 9, 42}});
  chip.words[sw::gantry_map::kIrq] = sw::gantry_map::kIrqTimer;
  chip.words[regs::kStatus] = regs::kStatusPass;
  app.isr(chip);
  CHECK(app.mailbox().point == 0);
}

TEST_CASE("gantry: polled bits are the temperatures, and other bits are unknown") {
  Track track;
  track.chip.words[regs::kOvertemp] = regs::kOvertempMotor2;
  CHECK(track.tell({{kPollBit, 0, 0}, {kPollBit, 1, 0}}) ==
        std::vector<Frame>{{kClearBit, 0, 0}, {kSetBit, 1, 0}});
  CHECK(track.app.unknown() == 0);
  CHECK(track.tell({{kPollBit, 2, 0}, {kClearBit, 0, 0}, {kSetBit, 1, 0}}).empty());
  CHECK(track.app.unknown() == 3);
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
  CHECK(track.app.unknown() == 4);
}

TEST_CASE("gantry: channel 11 restarts the observer only where its mask changes") {
  Track track;
  track.tell({{kValue, 11, 0x11}});
  CHECK(track.chip.writes[regs::kObserver] == 0);
  track.tell({{kValue, 11, 0xFF01}});
  CHECK(track.chip.writes[regs::kObserver] == 1);
  CHECK(track.chip.words[regs::kObserver] == 0x01);
}

TEST_CASE("gantry: channel 12 sets the slots of the observer or of the requester") {
  Track track;
  track.tell({{kValue, 12, 7 << 2 | 0}});
  CHECK(track.chip.words[regs::kSlots] == 0x0001'0007);
  track.tell({{kValue, 12, 254 << 2 | 2}});
  CHECK(track.chip.words[regs::kSlots] == 0x00FE'0007);
  track.tell({{kValue, 12, 255 << 2 | 2}, {kValue, 12, 1}, {kValue, 12, 3}});
  CHECK(track.chip.words[regs::kSlots] == 0x00FE'0007);
  CHECK(track.app.unknown() == 3);
}

TEST_CASE("gantry: channel 13 starts, sends and stores calibration data, and nothing else") {
  Track track;
  track.tell({{kValue, 13, 1 << 2}, {kValue, 13, 2 << 2 | 0xBEEFu << 6}, {kValue, 13, 7 << 2}});
  CHECK(track.chip.calibrated == std::vector<std::uint32_t>{0x1'0000, 0x2'BEEF, 0x7'0000});
  CHECK(track.app.unknown() == 0);
  track.tell({{kValue, 13, 3 << 2}});  // an address of the other bus: no error, no effect
  CHECK(track.app.unknown() == 0);
  track.tell({{kValue, 13, 0}, {kValue, 13, 4 << 2}, {kValue, 13, 15 << 2}});
  CHECK(track.chip.calibrated.size() == 3);
  CHECK(track.app.unknown() == 3);
}

TEST_CASE("gantry: a goal chooses its control; position is clipped, velocity has an offset") {
  sw::GantrySetup setup;
  Track track(setup);
  track.tell({{kValue, 21, 305}});
  CHECK(track.app.phase() == sw::GantryPhase::kPosition);
  CHECK(track.app.goal() == 1952);
  track.tell({{kValue, 21, 471}});
  CHECK(track.app.goal() == 3008);
  track.pass(0);
  CHECK(track.force(1) == -1023);  // toward larger positions
  CHECK(track.force(2) == -1023);
  track.tell({{kValue, 22, 170'000 + 50'000}});
  CHECK(track.app.phase() == sw::GantryPhase::kVelocity);
  CHECK(track.app.goal_velocity() == 50'000);
  track.pass(0);
  CHECK(track.force(1) < 0);
  track.tell({{kValue, 22, 170'000 - 50'000}});
  CHECK(track.app.goal_velocity() == -50'000);
  track.pass(0);
  CHECK(track.force(2) > 0);
  track.tell({{kValue, 21, 0}});
  CHECK(track.app.phase() == sw::GantryPhase::kPosition);
  track.tell({{kValue, 23, 1}});
  CHECK(track.app.unknown() == 1);
}

TEST_CASE("gantry: while the angle is not known no motor is driven") {
  Track track;
  track.tell({{kValue, 21, 305}});
  track.pass(0, 9, false);
  CHECK(track.chip.writes[regs::kForce1] == 0);
  track.pass(0);
  CHECK(track.chip.writes[regs::kForce1] == 1);
}

TEST_CASE("gantry: the configuration goes out as there is room, in passes, whole and once") {
  Track track;
  track.chip.words[regs::kSendState] = 5;
  std::vector<Frame> all = track.tell({{kPoll, 31, 0}});
  CHECK(all.size() == 5);
  for (int k = 0; k < 10; ++k) {
    track.chip.sent.clear();
    track.pass(0);
    all.insert(all.end(), track.chip.sent.begin(), track.chip.sent.end());
  }
  REQUIRE(all.size() == sw::gantry_channel::kConfigurationLength);
  for (std::size_t k = 0; k < all.size(); ++k) {
    CHECK(all[k] == Frame{kValue, 31, sw::gantry_channel::kConfigurationWords[k]});
  }
}

TEST_CASE("gantry: the stream is position, time and velocity, and waits for room") {
  sw::GantrySetup setup;
  setup.stream = true;
  Track track(setup);
  track.chip.words[regs::kSendState] = 7;
  track.pass(64);
  CHECK(track.chip.sent.empty());
  track.chip.words[regs::kSendState] = 8;
  track.pass(64);
  CHECK(track.chip.sent == std::vector<Frame>{{kValue, 7, (1 << 24) + 10},
                                              {kValue, 30, track.chip.words[regs::kTicks]},
                                              {kValue, 29, 1 << 22}});
}

TEST_CASE("gantry: a calibration run without a stripe fails, keeps the data and says so") {
  sw::GantrySetup setup;
  setup.calibrate = true;
  Track track(setup);
  track.pass(512);        // 80 mm, where the run begins
  track.pass(512, 5000);  // and the cart stood there
  REQUIRE(track.app.phase() == sw::GantryPhase::kFitting);
  CHECK(track.force(1) == -0x150);
  CHECK(track.force(2) == -0x150);
  track.tell({{kValue, 11, 0x01}, {kPoll, 1, 0}});  // the converter is the run's
  CHECK(track.chip.words[regs::kObserver] == 0);
  CHECK(track.app.unknown() == 1);
  track.chip.words[regs::kEncoderA] = track.chip.words[regs::kEncoderB] = 512;
  for (int k = 0; track.app.phase() == sw::GantryPhase::kFitting; ++k) {
    REQUIRE(k < 100'000);
    ++track.chip.words[regs::kTicks];
    track.interrupt(regs::kStatusSample);
  }
  CHECK(track.app.mailbox().failure ==
        static_cast<std::uint32_t>(sw::GantryFailure::kFitFailed));
  CHECK_FALSE(track.app.fitted());
  CHECK(track.chip.calibrated.empty());
  CHECK(track.force(1) == 0);
  CHECK(track.chip.words[regs::kObserver] == 0x11);
}

TEST_CASE("gantry: a velocity that falls far short winds nothing up, in either sense") {
  sw::VelocityPi::Config config;
  for (const std::int32_t sign : {1, -1}) {
    sw::VelocityPi::State state;
    state.sum = state.last_sum = sign * 1000;
    sw::VelocityPi::step(config, state, 0, sign * 600 * (1 << config.gain));
    CHECK(state.sum == sign * 1000);
    // Nearer, what both parts together exceed is taken from the sum, which is stored unshifted.
    state.sum = sign * std::int64_t{1'000'000'000};
    sw::VelocityPi::step(config, state, 0, sign * 10 * (1 << config.gain));
    CHECK(state.sum == sign * (config.aw_limit - 10));
  }
}
