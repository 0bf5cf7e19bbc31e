// Generated from rtl/chips/gantry_tau.rdl by scripts/tool gen-register-map; do not edit.
// SPDX-License-Identifier: Apache-2.0
//
// Registers of gantry_tau: addresses in bytes, bits, and what reads and writes do. Those of a
// register file are at base + offset, a system register at its own address.
#pragma once

#include <array>
#include <cstdint>

namespace trammel::gantry_tau_regs {

// system
inline constexpr std::uint32_t kId = 0x00u, kIdVersionShift = 0u, kIdVersionMask = 0x0000FFFFu,
    kIdChipShift = 16u, kIdChipMask = 0xFFFF0000u, kIdValue = 0x47540001u;
inline constexpr std::uint32_t kObserver = 0x04u, kObserverActive = 0x1u, kObserverVelocity = 0x10u;
inline constexpr std::uint32_t kPosition = 0x08u;
inline constexpr std::uint32_t kVelocity = 0x0Cu;
inline constexpr std::uint32_t kAngle = 0x10u, kAnglePhaseShift = 0u, kAnglePhaseMask = 0x00003FFFu,
    kAngleRegionShift = 16u, kAngleRegionMask = 0x00030000u, kAngleKnown = 0x80000000u;
inline constexpr std::uint32_t kTicks = 0x14u;
inline constexpr std::uint32_t kSlots = 0x18u, kSlotsObserverShift = 0u,
    kSlotsObserverMask = 0x000000FFu, kSlotsRequesterShift = 16u, kSlotsRequesterMask = 0x00FF0000u;
inline constexpr std::uint32_t kRequest = 0x1Cu, kRequestA = 0x1u, kRequestPendingShift = 0u,
    kRequestPendingMask = 0x0000007Fu, kRequestADot = 0x2u, kRequestB = 0x4u, kRequestBDot = 0x8u,
    kRequestCurrent = 0x40u;
inline constexpr std::uint32_t kEncoderA = 0x20u, kEncoderACodeShift = 0u,
    kEncoderACodeMask = 0x000003FFu, kEncoderADotShift = 16u, kEncoderADotMask = 0x03FF0000u;
inline constexpr std::uint32_t kEncoderB = 0x24u, kEncoderBCodeShift = 0u,
    kEncoderBCodeMask = 0x000003FFu, kEncoderBDotShift = 16u, kEncoderBDotMask = 0x03FF0000u;
inline constexpr std::uint32_t kCurrent = 0x28u, kCurrentCodeShift = 0u,
    kCurrentCodeMask = 0x000003FFu;
inline constexpr std::uint32_t kForce1 = 0x2Cu;
inline constexpr std::uint32_t kForce2 = 0x30u;
inline constexpr std::uint32_t kOvertemp = 0x34u, kOvertempMotor1 = 0x1u, kOvertempMotor2 = 0x2u;
inline constexpr std::uint32_t kPassPeriod = 0x38u, kPassPeriodClocksShift = 0u,
    kPassPeriodClocksMask = 0x00FFFFFFu;
inline constexpr std::uint32_t kStatus = 0x3Cu, kStatusPass = 0x1u, kStatusFrame = 0x2u,
    kStatusSample = 0x4u, kStatusOverrun = 0x8u, kStatusRefused = 0x10u, kStatusStored = 0x20u;
inline constexpr std::uint32_t kIrqEnable = 0x40u, kIrqEnablePass = 0x1u, kIrqEnableFrame = 0x2u,
    kIrqEnableSample = 0x4u;
inline constexpr std::uint32_t kReceive = 0x44u, kReceiveChannelShift = 0u,
    kReceiveChannelMask = 0x0000001Fu, kReceiveTake = 0x1u, kReceiveKindShift = 8u,
    kReceiveKindMask = 0x00000700u, kReceiveWaits = 0x80000000u;
inline constexpr std::uint32_t kReceiveValue = 0x48u;
inline constexpr std::uint32_t kReceiveErrors = 0x4Cu, kReceiveErrorsMalformedShift = 0u,
    kReceiveErrorsMalformedMask = 0x0000FFFFu, kReceiveErrorsLostShift = 16u,
    kReceiveErrorsLostMask = 0xFFFF0000u;
inline constexpr std::uint32_t kSendValue = 0x50u;
inline constexpr std::uint32_t kSend = 0x54u, kSendChannelShift = 0u,
    kSendChannelMask = 0x0000001Fu, kSendKindShift = 8u, kSendKindMask = 0x00000700u;
inline constexpr std::uint32_t kSendState = 0x58u, kSendStateRoomShift = 0u,
    kSendStateRoomMask = 0x0000003Fu, kSendStateIdle = 0x100u, kSendStateLostShift = 16u,
    kSendStateLostMask = 0xFFFF0000u;
inline constexpr std::uint32_t kCalibrate = 0x5Cu, kCalibrateWordShift = 0u,
    kCalibrateWordMask = 0x0000FFFFu, kCalibrateCommandShift = 16u,
    kCalibrateCommandMask = 0x00070000u;
inline constexpr std::uint32_t kCalibration = 0x60u, kCalibrationValid = 0x1u,
    kCalibrationBusy = 0x2u, kCalibrationCountShift = 8u, kCalibrationCountMask = 0x00003F00u;
inline constexpr std::uint32_t kReceiveGap = 0x64u, kReceiveGapClocksShift = 0u,
    kReceiveGapClocksMask = 0x00FFFFFFu;

enum class Access { kRead, kWrite, kReadWrite, kWriteOneToClear };

// A register at its own address, and what a read and a write do to its bits.
struct Register {
  const char* name;  // "x.CTRL", "TICK"
  std::uint32_t address;
  std::uint32_t reset;
  std::uint32_t readable;
  std::uint32_t written;  // bits that keep what is written
  std::uint32_t locked;   // of them, those that LOCK protects
  std::uint32_t cleared;  // bits that a written one clears
  std::uint32_t pulsed;   // bits that a written one sets for one clock
};

// Bits of a register, and the number in them.
struct Field {
  const char* name;  // "CTRL.enable"; a register of one field has its name alone
  const char* help;
  std::uint32_t address;  // of its register; in a register file, an offset
  int shift;
  int width;
  int bits;  // of the number: bits of the field above repeat its sign, or are 0
  bool is_signed;
  bool of_axis;  // each register file has one
  Access access;
};

// By address.
inline constexpr std::array<Register, 26> kRegisters{{
    {"ID", 0x000u, 0x47540001u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"OBSERVER", 0x004u, 0x00000000u, 0x00000011u, 0x00000011u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"POSITION", 0x008u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"VELOCITY", 0x00Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"ANGLE", 0x010u, 0x00000000u, 0x80033FFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"TICKS", 0x014u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"SLOTS", 0x018u, 0x00010002u, 0x00FF00FFu, 0x00FF00FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"REQUEST", 0x01Cu, 0x00000000u, 0x0000007Fu, 0x00000000u, 0x00000000u, 0x00000000u, 0x0000004Fu},
    {"ENCODER_A", 0x020u, 0x00000000u, 0x03FF03FFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"ENCODER_B", 0x024u, 0x00000000u, 0x03FF03FFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"CURRENT", 0x028u, 0x00000000u, 0x000003FFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"FORCE_1", 0x02Cu, 0x00000000u, 0x000007FFu, 0x000007FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"FORCE_2", 0x030u, 0x00000000u, 0x000007FFu, 0x000007FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"OVERTEMP", 0x034u, 0x00000000u, 0x00000003u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"PASS_PERIOD", 0x038u, 0x000186A0u, 0x00FFFFFFu, 0x00FFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"STATUS", 0x03Cu, 0x00000000u, 0x0000003Fu, 0x00000000u, 0x00000000u, 0x0000003Du, 0x00000000u},
    {"IRQ_ENABLE", 0x040u, 0x00000000u, 0x00000007u, 0x00000007u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"RECEIVE", 0x044u, 0x00000000u, 0x8000071Fu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000001u},
    {"RECEIVE_VALUE", 0x048u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"RECEIVE_ERRORS", 0x04Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"SEND_VALUE", 0x050u, 0x00000000u, 0xFFFFFFFFu, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"SEND", 0x054u, 0x00000400u, 0x0000071Fu, 0x0000071Fu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"SEND_STATE", 0x058u, 0x00000000u, 0xFFFF013Fu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"CALIBRATE", 0x05Cu, 0x00000000u, 0x0007FFFFu, 0x0007FFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"CALIBRATION", 0x060u, 0x00000000u, 0x00003F03u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"RECEIVE_GAP", 0x064u, 0x0007B3C6u, 0x00FFFFFFu, 0x00FFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
}};

inline constexpr std::array<Field, 56> kFields{{
    {"ID.version", "identity of the IC and version of its register map", 0x00u, 0, 16, 16, false, false, Access::kRead},
    {"ID.chip", "identity of the IC and version of its register map", 0x00u, 16, 16, 16, false, false, Access::kRead},
    {"OBSERVER.active", "position; needs a valid calibration", 0x04u, 0, 1, 1, false, false, Access::kReadWrite},
    {"OBSERVER.velocity", "velocity", 0x04u, 4, 1, 1, false, false, Access::kReadWrite},
    {"POSITION", "position, 2^-14 of a stripe period each; increases with the angle of (A, B)", 0x08u, 0, 32, 32, true, false, Access::kRead},
    {"VELOCITY", "velocity, 2^-9 position unit a tick each; bit 0: 0 derivative, 1 phase", 0x0Cu, 0, 32, 23, true, false, Access::kRead},
    {"ANGLE.phase", "2^14 a period", 0x10u, 0, 14, 14, false, false, Access::kRead},
    {"ANGLE.region", "region of the last sample; even ones use B, odd ones A", 0x10u, 16, 2, 2, false, false, Access::kRead},
    {"ANGLE.known", "a quarter was found since the restart", 0x10u, 31, 1, 1, false, false, Access::kRead},
    {"TICKS", "conversion ticks since reset, 4612 a second", 0x14u, 0, 32, 32, false, false, Access::kRead},
    {"SLOTS.observer", "of the observer; 0 = never", 0x18u, 0, 8, 8, false, false, Access::kReadWrite},
    {"SLOTS.requester", "of the requester; 0 = never", 0x18u, 16, 8, 8, false, false, Access::kReadWrite},
    {"REQUEST.a", "A", 0x1Cu, 0, 1, 1, false, false, Access::kWrite},
    {"REQUEST.pending", "asked for and not yet converted, bit = channel", 0x1Cu, 0, 7, 7, false, false, Access::kRead},
    {"REQUEST.a_dot", "dA/dt", 0x1Cu, 1, 1, 1, false, false, Access::kWrite},
    {"REQUEST.b", "B", 0x1Cu, 2, 1, 1, false, false, Access::kWrite},
    {"REQUEST.b_dot", "dB/dt", 0x1Cu, 3, 1, 1, false, false, Access::kWrite},
    {"REQUEST.current", "current", 0x1Cu, 6, 1, 1, false, false, Access::kWrite},
    {"ENCODER_A.code", "A", 0x20u, 0, 10, 10, false, false, Access::kRead},
    {"ENCODER_A.dot", "dA/dt", 0x20u, 16, 10, 10, false, false, Access::kRead},
    {"ENCODER_B.code", "B", 0x24u, 0, 10, 10, false, false, Access::kRead},
    {"ENCODER_B.dot", "dB/dt", 0x24u, 16, 10, 10, false, false, Access::kRead},
    {"CURRENT", "last code of the current", 0x28u, 0, 10, 10, false, false, Access::kRead},
    {"FORCE_1", "force of motor 1, 1023 is full; positive toward the right, the position decreases", 0x2Cu, 0, 11, 11, true, false, Access::kReadWrite},
    {"FORCE_2", "force of motor 2", 0x30u, 0, 11, 11, true, false, Access::kReadWrite},
    {"OVERTEMP.motor_1", "of motor 1", 0x34u, 0, 1, 1, false, false, Access::kRead},
    {"OVERTEMP.motor_2", "of motor 2", 0x34u, 1, 1, 1, false, false, Access::kRead},
    {"PASS_PERIOD", "clocks from control pass to control pass; below 16: none. A write begins anew", 0x38u, 0, 24, 24, false, false, Access::kReadWrite},
    {"STATUS.pass", "a control pass is due", 0x3Cu, 0, 1, 1, false, false, Access::kWriteOneToClear},
    {"STATUS.frame", "a received frame waits", 0x3Cu, 1, 1, 1, false, false, Access::kRead},
    {"STATUS.sample", "a requested conversion is done", 0x3Cu, 2, 1, 1, false, false, Access::kWriteOneToClear},
    {"STATUS.overrun", "a pass came due before the last was cleared", 0x3Cu, 3, 1, 1, false, false, Access::kWriteOneToClear},
    {"STATUS.refused", "calibration data was refused: count or checksum is wrong", 0x3Cu, 4, 1, 1, false, false, Access::kWriteOneToClear},
    {"STATUS.stored", "calibration data was taken and stored", 0x3Cu, 5, 1, 1, false, false, Access::kWriteOneToClear},
    {"IRQ_ENABLE.pass", "which events interrupt, as long as their bit in STATUS is 1", 0x40u, 0, 1, 1, false, false, Access::kReadWrite},
    {"IRQ_ENABLE.frame", "which events interrupt, as long as their bit in STATUS is 1", 0x40u, 1, 1, 1, false, false, Access::kReadWrite},
    {"IRQ_ENABLE.sample", "which events interrupt, as long as their bit in STATUS is 1", 0x40u, 2, 1, 1, false, false, Access::kReadWrite},
    {"RECEIVE.channel", "channel", 0x44u, 0, 5, 5, false, false, Access::kRead},
    {"RECEIVE.take", "1 takes it away: the next one shows", 0x44u, 0, 1, 1, false, false, Access::kWrite},
    {"RECEIVE.kind", "0 clear bit, 1 set bit, 2 poll bit, 3 poll channel, 4 value", 0x44u, 8, 3, 3, false, false, Access::kRead},
    {"RECEIVE.waits", "a frame waits; the other fields are its", 0x44u, 31, 1, 1, false, false, Access::kRead},
    {"RECEIVE_VALUE", "its value; 0 where it has none", 0x48u, 0, 32, 32, false, false, Access::kRead},
    {"RECEIVE_ERRORS.malformed", "malformed frames: overlong, with a byte without stop bit, or ended by the gap", 0x4Cu, 0, 16, 16, false, false, Access::kRead},
    {"RECEIVE_ERRORS.lost", "good frames for which there was no room", 0x4Cu, 16, 16, 16, false, false, Access::kRead},
    {"SEND_VALUE", "value of the frame that SEND sends", 0x50u, 0, 32, 32, false, false, Access::kReadWrite},
    {"SEND.channel", "channel", 0x54u, 0, 5, 5, false, false, Access::kReadWrite},
    {"SEND.kind", "as in RECEIVE; 4 sends SEND_VALUE in 2 to 6 bytes", 0x54u, 8, 3, 3, false, false, Access::kReadWrite},
    {"SEND_STATE.room", "that there is room for, up to 32", 0x58u, 0, 6, 6, false, false, Access::kRead},
    {"SEND_STATE.idle", "none waits and the line is at rest", 0x58u, 8, 1, 1, false, false, Access::kRead},
    {"SEND_STATE.lost", "refused since reset; ends at 65535", 0x58u, 16, 16, 16, false, false, Access::kRead},
    {"CALIBRATE.word", "word of command 2", 0x5Cu, 0, 16, 16, false, false, Access::kReadWrite},
    {"CALIBRATE.command", "1 start, 2 next word, 7 check, take and store", 0x5Cu, 16, 3, 3, false, false, Access::kReadWrite},
    {"CALIBRATION.valid", "the observer has one with the right checksum", 0x60u, 0, 1, 1, false, false, Access::kRead},
    {"CALIBRATION.busy", "the store is read or written; commands are ignored", 0x60u, 1, 1, 1, false, false, Access::kRead},
    {"CALIBRATION.count", "words since the start, 63 are all of them", 0x60u, 8, 6, 6, false, false, Access::kRead},
    {"RECEIVE_GAP", "most clocks from byte to byte of a frame; a partial one ends there. 0: any number", 0x64u, 0, 24, 24, false, false, Access::kReadWrite},
}};

}  // namespace trammel::gantry_tau_regs
