// SPDX-License-Identifier: Apache-2.0
//
// Channels of the gantry track on Serial2002, and the words by which it describes them (Brochier
// 2006, 2.2.3 and C.18). Freestanding.
#pragma once

#include <cstdint>

namespace trammel::sw::gantry_channel {

// To the host.
inline constexpr std::uint32_t kPosition = 0;  // [mm] + 2^24
inline constexpr std::uint32_t kA = 1, kB = 2, kCurrent = 3, kVelocity = 4, kADot = 5, kBDot = 6;
inline constexpr std::uint32_t kReset = 9;     // 42 at boot
// The stream: mm, conversions, 2^-9 position unit a conversion; without an offset.
inline constexpr std::uint32_t kStreamPosition = 7, kStreamTime = 30, kStreamVelocity = 29;

// From the host.
inline constexpr std::uint32_t kObserve = 11, kSlots = 12, kCalibrate = 13;
inline constexpr std::uint32_t kGoal = 21, kGoalVelocity = 22, kConfiguration = 31;
inline constexpr std::uint32_t kMotor = 0;     // its input is a goal as well (C.16)

// Either way, in the checked mode: the checksum of the frame before.
inline constexpr std::uint32_t kCheck = 27;

inline constexpr std::uint32_t kPositionOffset = 1u << 24, kVelocityOffset = 1u << 22;
inline constexpr std::uint32_t kResetMessage = 42;
inline constexpr std::int32_t kGoalVelocityOffset = 170'000;
inline constexpr std::uint32_t kMostGoal_mm = 470;
inline constexpr std::uint32_t kMostGoalVelocity = 2 * kGoalVelocityOffset;  // 467 mm/s

enum Form : std::uint32_t { kClearBit, kSetBit, kPollBit, kPollChannel, kValue };

struct Frame {
  std::uint32_t form = kClearBit, channel = 0, value = 0;
};

// CRC-16/CCITT-FALSE goes on with a byte; it begins with 0xFFFF.
constexpr std::uint32_t crc_with(std::uint32_t crc, std::uint32_t byte) {
  crc ^= byte << 8;
  for (int bit = 0; bit < 8; ++bit) {
    crc = (crc << 1 ^ ((crc & 0x8000) != 0 ? 0x1021u : 0)) & 0xFFFF;
  }
  return crc;
}

// Of the form and channel in a byte, then of the four bytes of the value, highest first.
constexpr std::uint32_t checksum_of(const Frame& frame) {
  std::uint32_t crc = crc_with(0xFFFF, frame.form << 5 | frame.channel);
  for (int k = 3; k >= 0; --k) crc = crc_with(crc, frame.value >> 8 * k & 0xFF);
  return crc;
}

enum Kind : std::uint32_t { kEnd, kDigitalIn, kDigitalOut, kAnalogIn, kAnalogOut, kEncoder };

constexpr std::uint32_t described(std::uint32_t channel, Kind kind) {
  return channel | static_cast<std::uint32_t>(kind) << 5;
}
constexpr std::uint32_t with_bits(std::uint32_t channel, Kind kind, std::uint32_t bits) {
  return described(channel, kind) | bits << 10;
}
// A bound in volts: command 1 least, 2 most.
constexpr std::uint32_t bound(std::uint32_t channel, Kind kind, std::uint32_t command,
                              std::int32_t volts) {
  const std::uint32_t size = static_cast<std::uint32_t>(volts < 0 ? -volts : volts);
  return described(channel, kind) | command << 8 | (volts < 0 ? 1u : 0u) << 13 | size << 14;
}

inline constexpr std::uint32_t kConfigurationWords[] = {
    with_bits(0, kDigitalIn, 1),  with_bits(1, kDigitalIn, 1),  with_bits(0, kEncoder, 25),
    with_bits(1, kAnalogIn, 10),  bound(1, kAnalogIn, 1, 0),    bound(1, kAnalogIn, 2, 5),
    with_bits(2, kAnalogIn, 10),  bound(2, kAnalogIn, 1, 0),    bound(2, kAnalogIn, 2, 5),
    with_bits(5, kAnalogIn, 10),  bound(5, kAnalogIn, 1, 0),    bound(5, kAnalogIn, 2, 5),
    with_bits(6, kAnalogIn, 10),  bound(6, kAnalogIn, 1, 0),    bound(6, kAnalogIn, 2, 5),
    with_bits(3, kAnalogIn, 8),   bound(3, kAnalogIn, 1, 0),    bound(3, kAnalogIn, 2, 5),
    with_bits(4, kEncoder, 23),   with_bits(0, kAnalogOut, 11), bound(0, kAnalogOut, 1, -12),
    bound(0, kAnalogOut, 2, 12),  0};
inline constexpr std::uint32_t kConfigurationLength =
    sizeof kConfigurationWords / sizeof kConfigurationWords[0];

}  // namespace trammel::sw::gantry_channel
