// SPDX-License-Identifier: Apache-2.0
//
// What each channel of Serial2002 does.
#include "rtl/chips/generated/gantry_tau_regs.hpp"
#include "sw_nios/apps/gantry/gantry.hpp"
#include "sw_nios/apps/gantry/protocol.hpp"

namespace trammel::sw {
namespace {

namespace tau = gantry_tau_regs;
namespace channel_of = gantry_channel;

using channel_of::kClearBit, channel_of::kSetBit, channel_of::kPollBit, channel_of::kPollChannel,
    channel_of::kValue;

void put(Bus& bus, const channel_of::Frame& frame) {
  if (frame.form == kValue) bus.write(tau::kSendValue, frame.value);
  bus.write(tau::kSend, frame.channel | frame.form << 8);
}

// The converter's channel of one of the protocol: A, dA/dt, B, dB/dt, current; -1: none.
std::int32_t converter_of(std::uint32_t channel) {
  switch (channel) {
    case channel_of::kA: return 0;
    case channel_of::kADot: return 1;
    case channel_of::kB: return 2;
    case channel_of::kBDot: return 3;
    case channel_of::kCurrent: return 6;
    default: return -1;
  }
}

}  // namespace

// Position in whole millimetres, toward minus infinity: 16384 units are 5 mm.
std::int32_t GantryApp::millimetres() const {
  const std::int64_t units = units_ - std::int64_t{mail_.zero} * 512;
  return static_cast<std::int32_t>(units * 5 >> 14);
}

void GantryApp::receive(Bus& bus) {
  for (;;) {
    const std::uint32_t word = bus.read(tau::kReceive);
    if ((word & tau::kReceiveWaits) == 0) return;
    const Frame frame{(word & tau::kReceiveKindMask) >> tau::kReceiveKindShift,
                      word & tau::kReceiveChannelMask, bus.read(tau::kReceiveValue)};
    bus.write(tau::kReceive, tau::kReceiveTake);
    if (c_.checked) {
      check(bus, frame);
    } else {
      act(bus, frame);
    }
  }
}

// A frame acts when the next one is its checksum.
void GantryApp::check(Bus& bus, const Frame& frame) {
  const bool sum = frame.form == kValue && frame.channel == channel_of::kCheck;
  if (sum && holds_ && frame.value == channel_of::checksum_of(held_)) {
    holds_ = false;
    act(bus, held_);
    return;
  }
  if (sum || holds_) ++mail_.unchecked;
  holds_ = !sum;
  held_ = frame;
}

void GantryApp::act(Bus& bus, const Frame& frame) {
  const std::uint32_t channel = frame.channel;
  switch (frame.form) {
    case kValue: set(bus, channel, frame.value); break;
    case kPollChannel: poll(bus, channel); break;
    case kPollBit:
      if (channel < 2) {
        const bool hot = (bus.read(tau::kOvertemp) >> channel & 1) != 0;
        send(bus, {hot ? kSetBit : kClearBit, channel, 0});
      } else {
        ++mail_.unknown;
      }
      break;
    default: ++mail_.unknown;  // there is no digital output
  }
}

// Frames that there is room for.
std::uint32_t GantryApp::room(Bus& bus) const {
  const std::uint32_t frames = bus.read(tau::kSendState) & tau::kSendStateRoomMask;
  return c_.checked ? frames / 2 : frames;
}

void GantryApp::send(Bus& bus, const Frame& frame) {
  if (room(bus) == 0) {
    ++mail_.unsent;
    return;
  }
  put(bus, frame);
  if (c_.checked) put(bus, {kValue, channel_of::kCheck, channel_of::checksum_of(frame)});
}

void GantryApp::set(Bus& bus, std::uint32_t channel, std::uint32_t value) {
  const bool fitting = mail_.phase == GantryPhase::kFitting;
  switch (channel) {
    case channel_of::kObserve: {
      const std::uint32_t mask = value & (tau::kObserverActive | tau::kObserverVelocity);
      if (!fitting && mask != observed_) observe(bus, mask);  // a write restarts the observer
      return;
    }
    case channel_of::kSlots: {
      const std::uint32_t client = value & 3, slots = value >> 2;
      if (client == 1 || client == 3 || slots > 254) {
        ++mail_.unknown;
        return;
      }
      const std::uint32_t old = bus.read(tau::kSlots);
      bus.write(tau::kSlots, client == 0 ? (old & ~tau::kSlotsObserverMask) | slots
                                          : (old & tau::kSlotsObserverMask) | slots << 16);
      return;
    }
    case channel_of::kCalibrate: {
      const std::uint32_t command = value >> 2 & 15;
      if (command == 1 || command == 2 || command == 7) {
        bus.write(tau::kCalibrate, command << 16 | (value >> 6 & 0xFFFF));
      } else if (command != 3) {  // an address of the other bus, which this chip has not
        ++mail_.unknown;
      }
      return;
    }
    case channel_of::kMotor:
    case channel_of::kGoal: {
      const bool outside = value > channel_of::kMostGoal_mm;
      if (outside && !c_.clip_goals) {
        ++mail_.refused;
        return;
      }
      const std::uint32_t mm = outside ? channel_of::kMostGoal_mm : value;
      mail_.goal = static_cast<std::int32_t>(mm * 32 / 5);
      if (mail_.phase == GantryPhase::kIdle || mail_.phase == GantryPhase::kVelocity) {
        mail_.phase = GantryPhase::kPosition;
      }
      return;
    }
    case channel_of::kGoalVelocity:
      if (value > channel_of::kMostGoalVelocity && !c_.clip_goals) {
        ++mail_.refused;
        return;
      }
      mail_.goal_velocity = narrowed(std::int64_t{value} - channel_of::kGoalVelocityOffset);
      if (mail_.phase == GantryPhase::kIdle || mail_.phase == GantryPhase::kPosition) {
        mail_.phase = GantryPhase::kVelocity;
      }
      return;
    default: ++mail_.unknown;
  }
}

void GantryApp::poll(Bus& bus, std::uint32_t channel) {
  const std::int32_t converter = converter_of(channel);
  if (channel == channel_of::kConfiguration) {
    ++lists_;
    describe(bus);
  } else if (channel == channel_of::kPosition) {
    const auto mm = static_cast<std::uint32_t>(millimetres());
    send(bus, {kValue, channel, mm + channel_of::kPositionOffset});
  } else if (channel == channel_of::kVelocity) {
    const std::uint32_t velocity = bus.read(tau::kVelocity) + channel_of::kVelocityOffset;
    send(bus, {kValue, channel, velocity & 0x7FFFFF});
  } else if (converter >= 0 && mail_.phase != GantryPhase::kFitting) {
    asked_ |= 1u << converter;
    bus.write(tau::kRequest, 1u << converter);
  } else {
    ++mail_.unknown;
  }
}

// Conversions that the host asked for and that are done.
void GantryApp::answer_samples(Bus& bus) {
  const std::uint32_t done = asked_ & ~bus.read(tau::kRequest);
  asked_ &= ~done;
  const std::uint32_t a = bus.read(tau::kEncoderA), b = bus.read(tau::kEncoderB);
  if ((done & 1u << 0) != 0) send(bus, {kValue, channel_of::kA, a & 0x3FF});
  if ((done & 1u << 1) != 0) send(bus, {kValue, channel_of::kADot, a >> 16 & 0x3FF});
  if ((done & 1u << 2) != 0) send(bus, {kValue, channel_of::kB, b & 0x3FF});
  if ((done & 1u << 3) != 0) send(bus, {kValue, channel_of::kBDot, b >> 16 & 0x3FF});
  if ((done & 1u << 6) != 0) {
    send(bus, {kValue, channel_of::kCurrent, bus.read(tau::kCurrent) >> 2 & 0xFF});
  }
}

// As much of the configuration as there is room for, once for each poll; the next passes send the
// rest.
void GantryApp::describe(Bus& bus) {
  for (std::uint32_t free = room(bus); free > 0 && lists_ > 0; --free) {
    const std::uint32_t word = channel_of::kConfigurationWords[described_++];
    send(bus, {kValue, channel_of::kConfiguration, word});
    if (described_ == channel_of::kConfigurationLength) {
      described_ = 0;
      --lists_;
    }
  }
}

// Plain integers of 32 bits in two's complement, as the listing sends and its reader plots them
// (appendix C.14 and B.1). The offsets are of the polled counters.
void GantryApp::stream(Bus& bus, std::uint32_t ticks) {
  if (room(bus) < 8) return;
  send(bus, {kValue, channel_of::kStreamPosition, static_cast<std::uint32_t>(millimetres())});
  send(bus, {kValue, channel_of::kStreamTime, ticks});
  send(bus, {kValue, channel_of::kStreamVelocity, static_cast<std::uint32_t>(mail_.velocity)});
}

}  // namespace trammel::sw
