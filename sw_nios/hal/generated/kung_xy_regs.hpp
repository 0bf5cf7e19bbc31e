// Generated from rtl/chips/kung_xy.rdl by scripts/gen_regs.py; do not edit.
// SPDX-License-Identifier: Apache-2.0
//
// Byte addresses and bits of the registers of kung_xy: those of a file
// are at base + offset, a system register at its own address.
#pragma once

#include <cstdint>

namespace trammel::sw::kung_xy_regs {

inline constexpr std::uint32_t kX = 0x000u;
inline constexpr std::uint32_t kY = 0x100u;

// axis_regs
inline constexpr std::uint32_t kCtrl = 0x00u;
inline constexpr std::uint32_t kCtrlEnable = 0x1u;
inline constexpr std::uint32_t kCtrlCurrentLoop = 0x2u;
inline constexpr std::uint32_t kCtrlPositionLoop = 0x4u;
inline constexpr std::uint32_t kCtrlAdapt = 0x8u;
inline constexpr std::uint32_t kCtrlResetModel = 0x10u;
inline constexpr std::uint32_t kCtrlResetTable = 0x20u;
inline constexpr std::uint32_t kCtrlInterpolate = 0x40u;
inline constexpr std::uint32_t kCtrlFeedforward = 0x80u;
inline constexpr std::uint32_t kStatus = 0x04u;
inline constexpr std::uint32_t kStatusBusy = 0x1u;
inline constexpr std::uint32_t kStatusOverrun = 0x2u;
inline constexpr std::uint32_t kStatusQepError = 0x4u;
inline constexpr std::uint32_t kStatusSaturated = 0x8u;
inline constexpr std::uint32_t kStatusLimited = 0x10u;
inline constexpr std::uint32_t kStatusStepShift = 8u;
inline constexpr std::uint32_t kStatusStepMask = 0x00007F00u;
inline constexpr std::uint32_t kPosCmd = 0x08u;
inline constexpr std::uint32_t kPos = 0x0Cu;
inline constexpr std::uint32_t kPosModel = 0x10u;
inline constexpr std::uint32_t kErr = 0x14u;
inline constexpr std::uint32_t kDerr = 0x18u;
inline constexpr std::uint32_t kU = 0x1Cu;
inline constexpr std::uint32_t kVstar = 0x20u;
inline constexpr std::uint32_t kIqCmd = 0x24u;
inline constexpr std::uint32_t kSpeed = 0x28u;
inline constexpr std::uint32_t kIdIq = 0x2Cu;
inline constexpr std::uint32_t kIdIqIDShift = 0u;
inline constexpr std::uint32_t kIdIqIDMask = 0x0000FFFFu;
inline constexpr std::uint32_t kIdIqIQShift = 16u;
inline constexpr std::uint32_t kIdIqIQMask = 0xFFFF0000u;
inline constexpr std::uint32_t kVdVq = 0x30u;
inline constexpr std::uint32_t kVdVqVDShift = 0u;
inline constexpr std::uint32_t kVdVqVDMask = 0x0000FFFFu;
inline constexpr std::uint32_t kVdVqVQShift = 16u;
inline constexpr std::uint32_t kVdVqVQMask = 0xFFFF0000u;
inline constexpr std::uint32_t kKp = 0x40u;
inline constexpr std::uint32_t kKpMantShift = 0u;
inline constexpr std::uint32_t kKpMantMask = 0x000007FFu;
inline constexpr std::uint32_t kKpExpShift = 16u;
inline constexpr std::uint32_t kKpExpMask = 0x001F0000u;
inline constexpr std::uint32_t kKi = 0x44u;
inline constexpr std::uint32_t kKiMantShift = 0u;
inline constexpr std::uint32_t kKiMantMask = 0x000007FFu;
inline constexpr std::uint32_t kKiExpShift = 16u;
inline constexpr std::uint32_t kKiExpMask = 0x001F0000u;
inline constexpr std::uint32_t kKv = 0x48u;
inline constexpr std::uint32_t kKvMantShift = 0u;
inline constexpr std::uint32_t kKvMantMask = 0x000007FFu;
inline constexpr std::uint32_t kKvExpShift = 16u;
inline constexpr std::uint32_t kKvExpMask = 0x001F0000u;
inline constexpr std::uint32_t kEta = 0x4Cu;
inline constexpr std::uint32_t kEtaMantShift = 0u;
inline constexpr std::uint32_t kEtaMantMask = 0x000007FFu;
inline constexpr std::uint32_t kEtaExpShift = 16u;
inline constexpr std::uint32_t kEtaExpMask = 0x001F0000u;
inline constexpr std::uint32_t kShift = 0x50u;
inline constexpr std::uint32_t kShiftEShift = 0u;
inline constexpr std::uint32_t kShiftEMask = 0x0000000Fu;
inline constexpr std::uint32_t kShiftDeShift = 8u;
inline constexpr std::uint32_t kShiftDeMask = 0x00000F00u;
inline constexpr std::uint32_t kA0 = 0x54u;
inline constexpr std::uint32_t kB2 = 0x58u;
inline constexpr std::uint32_t kKpCur = 0x60u;
inline constexpr std::uint32_t kKpCurMantShift = 0u;
inline constexpr std::uint32_t kKpCurMantMask = 0x000007FFu;
inline constexpr std::uint32_t kKpCurExpShift = 16u;
inline constexpr std::uint32_t kKpCurExpMask = 0x001F0000u;
inline constexpr std::uint32_t kKiCur = 0x64u;
inline constexpr std::uint32_t kKiCurMantShift = 0u;
inline constexpr std::uint32_t kKiCurMantMask = 0x000007FFu;
inline constexpr std::uint32_t kKiCurExpShift = 16u;
inline constexpr std::uint32_t kKiCurExpMask = 0x001F0000u;
inline constexpr std::uint32_t kThetaOfs = 0x68u;
inline constexpr std::uint32_t kDeadtime = 0x6Cu;
inline constexpr std::uint32_t kDeadtimeClkShift = 0u;
inline constexpr std::uint32_t kDeadtimeClkMask = 0x000003FFu;
inline constexpr std::uint32_t kDeadtimeQepFilterShift = 16u;
inline constexpr std::uint32_t kDeadtimeQepFilterMask = 0x000F0000u;
inline constexpr std::uint32_t kTabAddr = 0x70u;
inline constexpr std::uint32_t kTabAddrIndexShift = 0u;
inline constexpr std::uint32_t kTabAddrIndexMask = 0x0000003Fu;
inline constexpr std::uint32_t kTabData = 0x74u;
inline constexpr std::uint32_t kPosPreset = 0x78u;
inline constexpr std::uint32_t kIndexLatch = 0x7Cu;
inline constexpr std::uint32_t kStrokeMin = 0x80u;
inline constexpr std::uint32_t kStrokeMax = 0x84u;
inline constexpr std::uint32_t kStrokeEn = 0x88u;
inline constexpr std::uint32_t kStrokeEnEnable = 0x1u;
inline constexpr std::uint32_t kIqManual = 0x8Cu;

// system
inline constexpr std::uint32_t kId = 0x200u;
inline constexpr std::uint32_t kIdVersionShift = 0u;
inline constexpr std::uint32_t kIdVersionMask = 0x0000FFFFu;
inline constexpr std::uint32_t kIdChipShift = 16u;
inline constexpr std::uint32_t kIdChipMask = 0xFFFF0000u;
inline constexpr std::uint32_t kIdValue = 0x4B580001u;
inline constexpr std::uint32_t kCommit = 0x204u;
inline constexpr std::uint32_t kCommitTake = 0x1u;
inline constexpr std::uint32_t kIrqEn = 0x208u;
inline constexpr std::uint32_t kIrqEnTick = 0x1u;
inline constexpr std::uint32_t kIrqEnFault = 0x2u;
inline constexpr std::uint32_t kIrqStat = 0x20Cu;
inline constexpr std::uint32_t kIrqStatTick = 0x1u;
inline constexpr std::uint32_t kIrqStatFault = 0x2u;
inline constexpr std::uint32_t kTick = 0x210u;
inline constexpr std::uint32_t kFault = 0x214u;
inline constexpr std::uint32_t kFaultCodeShift = 0u;
inline constexpr std::uint32_t kFaultCodeMask = 0x0000000Fu;
inline constexpr std::uint32_t kFaultAxis = 0x10u;
inline constexpr std::uint32_t kFaultTickShift = 8u;
inline constexpr std::uint32_t kFaultTickMask = 0xFFFFFF00u;
inline constexpr std::uint32_t kFaultClear = 0x218u;
inline constexpr std::uint32_t kWatchdog = 0x21Cu;
inline constexpr std::uint32_t kWatchdogLimitShift = 0u;
inline constexpr std::uint32_t kWatchdogLimitMask = 0x0000FFFFu;
inline constexpr std::uint32_t kLock = 0x220u;
inline constexpr std::uint32_t kCurrentLimit = 0x224u;
inline constexpr std::uint32_t kDeadtimeMin = 0x228u;
inline constexpr std::uint32_t kDeadtimeMinClkShift = 0u;
inline constexpr std::uint32_t kDeadtimeMinClkMask = 0x000003FFu;
inline constexpr std::uint32_t kIrqPeriod = 0x22Cu;
inline constexpr std::uint32_t kIrqPeriodTicksShift = 0u;
inline constexpr std::uint32_t kIrqPeriodTicksMask = 0x000000FFu;

// fault_code
inline constexpr std::uint32_t kFaultCodeNone = 0x0u;  // no fault since the last clear
inline constexpr std::uint32_t kFaultCodeExternalTrip = 0x1u;  // trip pin
inline constexpr std::uint32_t kFaultCodeOverCurrent = 0x2u;
inline constexpr std::uint32_t kFaultCodeWatchdog = 0x3u;  // no COMMIT for WATCHDOG ticks
inline constexpr std::uint32_t kFaultCodeEncoder = 0x4u;  // double transition of the encoder lines
inline constexpr std::uint32_t kFaultCodeStroke = 0x5u;  // position outside STROKE_MIN..STROKE_MAX

// key
inline constexpr std::uint32_t kKeyLock = 0x4C4F434Bu;  // to LOCK: set the lock (ASCII LOCK)
inline constexpr std::uint32_t kKeyUnlock = 0x554E4C4Bu;
inline constexpr std::uint32_t kKeyFaultClear = 0x434C5246u;

}  // namespace trammel::sw::kung_xy_regs
