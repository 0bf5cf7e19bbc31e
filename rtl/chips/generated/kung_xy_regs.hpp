// Generated from rtl/chips/kung_xy.rdl by scripts/tool gen-register-map; do not edit.
// SPDX-License-Identifier: Apache-2.0
//
// Registers of kung_xy: addresses in bytes, bits, and what reads and writes do. Those of a register
// file are at base + offset, a system register at its own address.
#pragma once

#include <array>
#include <cstdint>

namespace trammel::kung_xy_regs {

inline constexpr std::uint32_t kX = 0x000u;
inline constexpr std::uint32_t kY = 0x100u;

// axis_regs
inline constexpr std::uint32_t kCtrl = 0x00u, kCtrlEnable = 0x1u, kCtrlCurrentLoop = 0x2u,
    kCtrlPositionLoop = 0x4u, kCtrlAdapt = 0x8u, kCtrlResetModel = 0x10u, kCtrlResetTable = 0x20u,
    kCtrlInterpolate = 0x40u, kCtrlFeedforward = 0x80u, kCtrlPrecision = 0x100u;
inline constexpr std::uint32_t kStatus = 0x04u, kStatusBusy = 0x1u, kStatusOverrun = 0x2u,
    kStatusQepError = 0x4u, kStatusSaturated = 0x8u, kStatusLimited = 0x10u,
    kStatusUnderrun = 0x20u, kStatusClipped = 0x40u, kStatusStepShift = 8u,
    kStatusStepMask = 0x00007F00u;
inline constexpr std::uint32_t kPosCmd = 0x08u;
inline constexpr std::uint32_t kPos = 0x0Cu;
inline constexpr std::uint32_t kPosModel = 0x10u;
inline constexpr std::uint32_t kErr = 0x14u;
inline constexpr std::uint32_t kDerr = 0x18u;
inline constexpr std::uint32_t kU = 0x1Cu;
inline constexpr std::uint32_t kVstar = 0x20u;
inline constexpr std::uint32_t kIqCmd = 0x24u;
inline constexpr std::uint32_t kSpeed = 0x28u;
inline constexpr std::uint32_t kIdIq = 0x2Cu, kIdIqIDShift = 0u, kIdIqIDMask = 0x0000FFFFu,
    kIdIqIQShift = 16u, kIdIqIQMask = 0xFFFF0000u;
inline constexpr std::uint32_t kVdVq = 0x30u, kVdVqVDShift = 0u, kVdVqVDMask = 0x0000FFFFu,
    kVdVqVQShift = 16u, kVdVqVQMask = 0xFFFF0000u;
inline constexpr std::uint32_t kKp = 0x40u, kKpMantShift = 0u, kKpMantMask = 0x000007FFu,
    kKpExpShift = 16u, kKpExpMask = 0x001F0000u;
inline constexpr std::uint32_t kKi = 0x44u, kKiMantShift = 0u, kKiMantMask = 0x000007FFu,
    kKiExpShift = 16u, kKiExpMask = 0x001F0000u;
inline constexpr std::uint32_t kKv = 0x48u, kKvMantShift = 0u, kKvMantMask = 0x000007FFu,
    kKvExpShift = 16u, kKvExpMask = 0x001F0000u;
inline constexpr std::uint32_t kEta = 0x4Cu, kEtaMantShift = 0u, kEtaMantMask = 0x000007FFu,
    kEtaExpShift = 16u, kEtaExpMask = 0x001F0000u;
inline constexpr std::uint32_t kShift = 0x50u, kShiftEShift = 0u, kShiftEMask = 0x0000001Fu,
    kShiftDeShift = 8u, kShiftDeMask = 0x00001F00u;
inline constexpr std::uint32_t kA0 = 0x54u, kA0ValueShift = 0u, kA0ValueMask = 0x0003FFFFu,
    kA0ScaleShift = 20u, kA0ScaleMask = 0x00300000u;
inline constexpr std::uint32_t kB2 = 0x58u;
inline constexpr std::uint32_t kKpCur = 0x60u, kKpCurMantShift = 0u, kKpCurMantMask = 0x000007FFu,
    kKpCurExpShift = 16u, kKpCurExpMask = 0x001F0000u;
inline constexpr std::uint32_t kKiCur = 0x64u, kKiCurMantShift = 0u, kKiCurMantMask = 0x000007FFu,
    kKiCurExpShift = 16u, kKiCurExpMask = 0x001F0000u;
inline constexpr std::uint32_t kThetaOfs = 0x68u;
inline constexpr std::uint32_t kDeadtime = 0x6Cu, kDeadtimeClkShift = 0u,
    kDeadtimeClkMask = 0x000003FFu, kDeadtimeQepFilterShift = 16u,
    kDeadtimeQepFilterMask = 0x000F0000u;
inline constexpr std::uint32_t kTabAddr = 0x70u, kTabAddrIndexShift = 0u,
    kTabAddrIndexMask = 0x0000003Fu;
inline constexpr std::uint32_t kTabData = 0x74u;
inline constexpr std::uint32_t kPosPreset = 0x78u;
inline constexpr std::uint32_t kIndexLatch = 0x7Cu;
inline constexpr std::uint32_t kStrokeMin = 0x80u;
inline constexpr std::uint32_t kStrokeMax = 0x84u;
inline constexpr std::uint32_t kStrokeEn = 0x88u, kStrokeEnEnable = 0x1u;
inline constexpr std::uint32_t kIqManual = 0x8Cu;
inline constexpr std::uint32_t kPrecAddr = 0x90u, kPrecAddrWordShift = 0u,
    kPrecAddrWordMask = 0x0000001Fu;
inline constexpr std::uint32_t kPrecData = 0x94u;
inline constexpr std::uint32_t kPrecErr = 0x98u;
inline constexpr std::uint32_t kErrSum = 0x9Cu;
inline constexpr std::uint32_t kIqSum = 0xA0u;
inline constexpr std::uint32_t kPrecDist = 0xA4u;
inline constexpr std::uint32_t kAngleStep = 0xB0u;
inline constexpr std::uint32_t kCurrentOffset = 0xB4u, kCurrentOffsetAShift = 0u,
    kCurrentOffsetAMask = 0x00000FFFu, kCurrentOffsetBShift = 16u,
    kCurrentOffsetBMask = 0x0FFF0000u;
inline constexpr std::uint32_t kPhaseCurrents = 0xB8u, kPhaseCurrentsIAShift = 0u,
    kPhaseCurrentsIAMask = 0x0000FFFFu, kPhaseCurrentsIBShift = 16u,
    kPhaseCurrentsIBMask = 0xFFFF0000u;
inline constexpr std::uint32_t kAdcFrame = 0xBCu, kAdcFrameZerosShift = 0u,
    kAdcFrameZerosMask = 0x00000007u;

// system
inline constexpr std::uint32_t kId = 0x200u, kIdVersionShift = 0u, kIdVersionMask = 0x0000FFFFu,
    kIdChipShift = 16u, kIdChipMask = 0xFFFF0000u, kIdValue = 0x4B580005u;
inline constexpr std::uint32_t kCommit = 0x204u, kCommitTake = 0x1u;
inline constexpr std::uint32_t kIrqEn = 0x208u, kIrqEnTick = 0x1u, kIrqEnFault = 0x2u;
inline constexpr std::uint32_t kIrqStat = 0x20Cu, kIrqStatTick = 0x1u, kIrqStatFault = 0x2u;
inline constexpr std::uint32_t kTick = 0x210u;
inline constexpr std::uint32_t kFault = 0x214u, kFaultCodeShift = 0u, kFaultCodeMask = 0x0000000Fu,
    kFaultAxis = 0x10u, kFaultTickShift = 8u, kFaultTickMask = 0xFFFFFF00u;
inline constexpr std::uint32_t kFaultClear = 0x218u;
inline constexpr std::uint32_t kWatchdog = 0x21Cu, kWatchdogLimitShift = 0u,
    kWatchdogLimitMask = 0x0000FFFFu;
inline constexpr std::uint32_t kLock = 0x220u;
inline constexpr std::uint32_t kCurrentLimit = 0x224u;
inline constexpr std::uint32_t kDeadtimeMin = 0x228u, kDeadtimeMinClkShift = 0u,
    kDeadtimeMinClkMask = 0x000003FFu;
inline constexpr std::uint32_t kIrqPeriod = 0x22Cu, kIrqPeriodTicksShift = 0u,
    kIrqPeriodTicksMask = 0x000000FFu;
inline constexpr std::uint32_t kKnot = 0x230u, kKnotCountShift = 0u, kKnotCountMask = 0xFFFFFFFFu;
inline constexpr std::uint32_t kRates = 0x240u, kRatesCarrierShift = 0u,
    kRatesCarrierMask = 0x00000003u, kRatesPositionShift = 4u, kRatesPositionMask = 0x00000030u;

// fault_code
inline constexpr std::uint32_t kFaultCodeNone = 0x0u;  // no fault since the last clear
inline constexpr std::uint32_t kFaultCodeExternalTrip = 0x1u;  // trip pin
inline constexpr std::uint32_t kFaultCodeOverCurrent = 0x2u;
inline constexpr std::uint32_t kFaultCodeWatchdog = 0x3u;  // no COMMIT within WATCHDOG ticks
inline constexpr std::uint32_t kFaultCodeEncoder = 0x4u;  // double transition of the encoder lines
inline constexpr std::uint32_t kFaultCodeStroke = 0x5u;  // position outside STROKE_MIN..STROKE_MAX

// key
inline constexpr std::uint32_t kKeyLock = 0x4C4F434Bu;  // to LOCK: sets the lock (ASCII LOCK)
inline constexpr std::uint32_t kKeyUnlock = 0x554E4C4Bu;
inline constexpr std::uint32_t kKeyFaultClear = 0x434C5246u;

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
inline constexpr std::array<Register, 98> kRegisters{{
    {"x.CTRL", 0x000u, 0x00000000u, 0x000001FFu, 0x000001DFu, 0x00000000u, 0x00000000u, 0x00000020u},
    {"x.STATUS", 0x004u, 0x00000000u, 0x00007F7Fu, 0x00000000u, 0x00000000u, 0x0000007Eu, 0x00000000u},
    {"x.POS_CMD", 0x008u, 0x00000000u, 0x00FFFFFFu, 0x00FFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.POS", 0x00Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.POS_MODEL", 0x010u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.ERR", 0x014u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.DERR", 0x018u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.U", 0x01Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.VSTAR", 0x020u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.IQ_CMD", 0x024u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.SPEED", 0x028u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.ID_IQ", 0x02Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.VD_VQ", 0x030u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.KP", 0x040u, 0x00000300u, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.KI", 0x044u, 0x00190347u, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.KV", 0x048u, 0x0001075Cu, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.ETA", 0x04Cu, 0x00180474u, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.SHIFT", 0x050u, 0x00000200u, 0x00001F1Fu, 0x00001F1Fu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.A0", 0x054u, 0x0003A1B8u, 0x0033FFFFu, 0x0033FFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.B2", 0x058u, 0x007C378Bu, 0x00FFFFFFu, 0x00FFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.KP_CUR", 0x060u, 0x000204FBu, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.KI_CUR", 0x064u, 0x001E05C6u, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.THETA_OFS", 0x068u, 0x00000000u, 0xFFFFFFFFu, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.DEADTIME", 0x06Cu, 0x00030064u, 0x000F03FFu, 0x000F03FFu, 0x000003FFu, 0x00000000u, 0x00000000u},
    {"x.TAB_ADDR", 0x070u, 0x00000000u, 0x0000003Fu, 0x0000003Fu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.TAB_DATA", 0x074u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.POS_PRESET", 0x078u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.INDEX_LATCH", 0x07Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.STROKE_MIN", 0x080u, 0x00000000u, 0x00FFFFFFu, 0x00FFFFFFu, 0x00FFFFFFu, 0x00000000u, 0x00000000u},
    {"x.STROKE_MAX", 0x084u, 0x0001D4C0u, 0x00FFFFFFu, 0x00FFFFFFu, 0x00FFFFFFu, 0x00000000u, 0x00000000u},
    {"x.STROKE_EN", 0x088u, 0x00000000u, 0x00000001u, 0x00000001u, 0x00000001u, 0x00000000u, 0x00000000u},
    {"x.IQ_MANUAL", 0x08Cu, 0x00000000u, 0x00000FFFu, 0x00000FFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.PREC_ADDR", 0x090u, 0x00000000u, 0x0000001Fu, 0x0000001Fu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.PREC_DATA", 0x094u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.PREC_ERR", 0x098u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.ERR_SUM", 0x09Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.IQ_SUM", 0x0A0u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.PREC_DIST", 0x0A4u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.ANGLE_STEP", 0x0B0u, 0x00055F2Fu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0x00000000u, 0x00000000u},
    {"x.CURRENT_OFFSET", 0x0B4u, 0x00000000u, 0x0FFF0FFFu, 0x0FFF0FFFu, 0x0FFF0FFFu, 0x00000000u, 0x00000000u},
    {"x.PHASE_CURRENTS", 0x0B8u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"x.ADC_FRAME", 0x0BCu, 0x00000004u, 0x00000007u, 0x00000007u, 0x00000007u, 0x00000000u, 0x00000000u},
    {"y.CTRL", 0x100u, 0x00000000u, 0x000001FFu, 0x000001DFu, 0x00000000u, 0x00000000u, 0x00000020u},
    {"y.STATUS", 0x104u, 0x00000000u, 0x00007F7Fu, 0x00000000u, 0x00000000u, 0x0000007Eu, 0x00000000u},
    {"y.POS_CMD", 0x108u, 0x00000000u, 0x00FFFFFFu, 0x00FFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.POS", 0x10Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.POS_MODEL", 0x110u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.ERR", 0x114u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.DERR", 0x118u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.U", 0x11Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.VSTAR", 0x120u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.IQ_CMD", 0x124u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.SPEED", 0x128u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.ID_IQ", 0x12Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.VD_VQ", 0x130u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.KP", 0x140u, 0x00000300u, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.KI", 0x144u, 0x00190347u, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.KV", 0x148u, 0x0001075Cu, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.ETA", 0x14Cu, 0x00180474u, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.SHIFT", 0x150u, 0x00000200u, 0x00001F1Fu, 0x00001F1Fu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.A0", 0x154u, 0x0003A1B8u, 0x0033FFFFu, 0x0033FFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.B2", 0x158u, 0x007C378Bu, 0x00FFFFFFu, 0x00FFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.KP_CUR", 0x160u, 0x000204FBu, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.KI_CUR", 0x164u, 0x001E05C6u, 0x001F07FFu, 0x001F07FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.THETA_OFS", 0x168u, 0x00000000u, 0xFFFFFFFFu, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.DEADTIME", 0x16Cu, 0x00030064u, 0x000F03FFu, 0x000F03FFu, 0x000003FFu, 0x00000000u, 0x00000000u},
    {"y.TAB_ADDR", 0x170u, 0x00000000u, 0x0000003Fu, 0x0000003Fu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.TAB_DATA", 0x174u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.POS_PRESET", 0x178u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.INDEX_LATCH", 0x17Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.STROKE_MIN", 0x180u, 0x00000000u, 0x00FFFFFFu, 0x00FFFFFFu, 0x00FFFFFFu, 0x00000000u, 0x00000000u},
    {"y.STROKE_MAX", 0x184u, 0x0001D4C0u, 0x00FFFFFFu, 0x00FFFFFFu, 0x00FFFFFFu, 0x00000000u, 0x00000000u},
    {"y.STROKE_EN", 0x188u, 0x00000000u, 0x00000001u, 0x00000001u, 0x00000001u, 0x00000000u, 0x00000000u},
    {"y.IQ_MANUAL", 0x18Cu, 0x00000000u, 0x00000FFFu, 0x00000FFFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.PREC_ADDR", 0x190u, 0x00000000u, 0x0000001Fu, 0x0000001Fu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.PREC_DATA", 0x194u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.PREC_ERR", 0x198u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.ERR_SUM", 0x19Cu, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.IQ_SUM", 0x1A0u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.PREC_DIST", 0x1A4u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.ANGLE_STEP", 0x1B0u, 0x00055F2Fu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0x00000000u, 0x00000000u},
    {"y.CURRENT_OFFSET", 0x1B4u, 0x00000000u, 0x0FFF0FFFu, 0x0FFF0FFFu, 0x0FFF0FFFu, 0x00000000u, 0x00000000u},
    {"y.PHASE_CURRENTS", 0x1B8u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"y.ADC_FRAME", 0x1BCu, 0x00000004u, 0x00000007u, 0x00000007u, 0x00000007u, 0x00000000u, 0x00000000u},
    {"ID", 0x200u, 0x4B580005u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"COMMIT", 0x204u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000001u},
    {"IRQ_EN", 0x208u, 0x00000000u, 0x00000003u, 0x00000003u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"IRQ_STAT", 0x20Cu, 0x00000000u, 0x00000003u, 0x00000000u, 0x00000000u, 0x00000003u, 0x00000000u},
    {"TICK", 0x210u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"FAULT", 0x214u, 0x00000000u, 0xFFFFFF1Fu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"FAULT_CLEAR", 0x218u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"WATCHDOG", 0x21Cu, 0x00000000u, 0x0000FFFFu, 0x0000FFFFu, 0x0000FFFFu, 0x00000000u, 0x00000000u},
    {"LOCK", 0x220u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"CURRENT_LIMIT", 0x224u, 0x00000500u, 0x00000FFFu, 0x00000FFFu, 0x00000FFFu, 0x00000000u, 0x00000000u},
    {"DEADTIME_MIN", 0x228u, 0x00000019u, 0x000003FFu, 0x000003FFu, 0x000003FFu, 0x00000000u, 0x00000000u},
    {"IRQ_PERIOD", 0x22Cu, 0x00000004u, 0x000000FFu, 0x000000FFu, 0x00000000u, 0x00000000u, 0x00000000u},
    {"KNOT", 0x230u, 0x00000000u, 0xFFFFFFFFu, 0x00000000u, 0x00000000u, 0x00000000u, 0x00000000u},
    {"RATES", 0x240u, 0x00000010u, 0x00000033u, 0x00000033u, 0x00000033u, 0x00000000u, 0x00000000u},
}};

inline constexpr std::array<Field, 90> kFields{{
    {"CTRL.enable", "inverter on", 0x00u, 0, 1, 1, false, true, Access::kReadWrite},
    {"CTRL.current_loop", "current loop closed (0: 50 % duty on all phases)", 0x00u, 1, 1, 1, false, true, Access::kReadWrite},
    {"CTRL.position_loop", "position loop closed (0: i_q* is IQ_MANUAL)", 0x00u, 2, 1, 1, false, true, Access::kReadWrite},
    {"CTRL.adapt", "adaptation: tune the rule table", 0x00u, 3, 1, 1, false, true, Access::kReadWrite},
    {"CTRL.reset_model", "hold model and integrators in their reset state", 0x00u, 4, 1, 1, false, true, Access::kReadWrite},
    {"CTRL.reset_table", "reset the rule table: self-clearing, STATUS.busy until it ends", 0x00u, 5, 1, 1, false, true, Access::kReadWrite},
    {"CTRL.interpolate", "interpolate commands over 4 ticks", 0x00u, 6, 1, 1, false, true, Access::kReadWrite},
    {"CTRL.feedforward", "velocity feed-forward", 0x00u, 7, 1, 1, false, true, Access::kReadWrite},
    {"CTRL.precision", "i_q* is the precision controller's; changed with reset_model only", 0x00u, 8, 1, 1, false, true, Access::kReadWrite},
    {"STATUS.busy", "position controller or table reset running", 0x04u, 0, 1, 1, false, true, Access::kRead},
    {"STATUS.overrun", "a tick came while the position controller ran", 0x04u, 1, 1, 1, false, true, Access::kWriteOneToClear},
    {"STATUS.qep_error", "double transition of the encoder; trips", 0x04u, 2, 1, 1, false, true, Access::kWriteOneToClear},
    {"STATUS.saturated", "i_q* was saturated", 0x04u, 3, 1, 1, false, true, Access::kWriteOneToClear},
    {"STATUS.limited", "the voltage vector was limited", 0x04u, 4, 1, 1, false, true, Access::kWriteOneToClear},
    {"STATUS.underrun", "a knot of the precision controller came without a COMMIT", 0x04u, 5, 1, 1, false, true, Access::kWriteOneToClear},
    {"STATUS.clipped", "the error of the precision controller was clipped", 0x04u, 6, 1, 1, false, true, Access::kWriteOneToClear},
    {"STATUS.step", "step of the position controller", 0x04u, 8, 7, 7, false, true, Access::kRead},
    {"POS_CMD", "position command [counts], taken after COMMIT", 0x08u, 0, 24, 24, true, true, Access::kReadWrite},
    {"POS", "position x_p latched at the position tick [counts]", 0x0Cu, 0, 32, 24, true, true, Access::kRead},
    {"POS_MODEL", "reference model output x_r [counts]", 0x10u, 0, 32, 24, true, true, Access::kRead},
    {"ERR", "error e [counts]", 0x14u, 0, 32, 12, true, true, Access::kRead},
    {"DERR", "error change de [counts per sample]", 0x18u, 0, 32, 12, true, true, Access::kRead},
    {"U", "fuzzy output u [1/256 unit]", 0x1Cu, 0, 32, 12, true, true, Access::kRead},
    {"VSTAR", "speed command v* [1/16 count per sample]", 0x20u, 0, 32, 12, true, true, Access::kRead},
    {"IQ_CMD", "current command i_q* [I_fs / 4096]", 0x24u, 0, 32, 12, true, true, Access::kRead},
    {"SPEED", "speed v [1/16 count per sample]", 0x28u, 0, 32, 12, true, true, Access::kRead},
    {"ID_IQ.i_d", "d current [I_fs / 2048]", 0x2Cu, 0, 16, 12, true, true, Access::kRead},
    {"ID_IQ.i_q", "q current [I_fs / 2048]", 0x2Cu, 16, 16, 12, true, true, Access::kRead},
    {"VD_VQ.v_d", "d voltage [V_dc / sqrt 3 / 2048]", 0x30u, 0, 16, 12, true, true, Access::kRead},
    {"VD_VQ.v_q", "q voltage [V_dc / sqrt 3 / 2048]", 0x30u, 16, 16, 12, true, true, Access::kRead},
    {"KP.mant", "mantissa / 2048", 0x40u, 0, 11, 11, false, true, Access::kReadWrite},
    {"KP.exp", "exponent of 2", 0x40u, 16, 5, 5, true, true, Access::kReadWrite},
    {"KI.mant", "mantissa / 2048", 0x44u, 0, 11, 11, false, true, Access::kReadWrite},
    {"KI.exp", "exponent of 2", 0x44u, 16, 5, 5, true, true, Access::kReadWrite},
    {"KV.mant", "mantissa / 2048", 0x48u, 0, 11, 11, false, true, Access::kReadWrite},
    {"KV.exp", "exponent of 2", 0x48u, 16, 5, 5, true, true, Access::kReadWrite},
    {"ETA.mant", "mantissa / 2048", 0x4Cu, 0, 11, 11, false, true, Access::kReadWrite},
    {"ETA.exp", "exponent of 2", 0x4Cu, 16, 5, 5, true, true, Access::kReadWrite},
    {"SHIFT.e", "shift of e; below -2 acts as -2", 0x50u, 0, 5, 5, true, true, Access::kReadWrite},
    {"SHIFT.de", "shift of de, likewise", 0x50u, 8, 5, 5, true, true, Access::kReadWrite},
    {"A0.value", "a0 in units of its scale", 0x54u, 0, 18, 18, false, true, Access::kReadWrite},
    {"A0.scale", "scale: 0 2^-32, 1 2^-28, 2 and 3 2^-23", 0x54u, 20, 2, 2, false, true, Access::kReadWrite},
    {"B2", "model coefficient B2 = b2 * 2^23", 0x58u, 0, 24, 24, true, true, Access::kReadWrite},
    {"KP_CUR.mant", "mantissa / 2048", 0x60u, 0, 11, 11, false, true, Access::kReadWrite},
    {"KP_CUR.exp", "exponent of 2", 0x60u, 16, 5, 5, true, true, Access::kReadWrite},
    {"KI_CUR.mant", "mantissa / 2048", 0x64u, 0, 11, 11, false, true, Access::kReadWrite},
    {"KI_CUR.exp", "exponent of 2", 0x64u, 16, 5, 5, true, true, Access::kReadWrite},
    {"THETA_OFS", "electrical angle at count 0 [2^-32 revolution]", 0x68u, 0, 32, 32, false, true, Access::kReadWrite},
    {"DEADTIME.clk", "dead time [clk]; locked by LOCK", 0x6Cu, 0, 10, 10, false, true, Access::kReadWrite},
    {"DEADTIME.qep_filter", "equal samples the encoder filter needs, 1..15", 0x6Cu, 16, 4, 4, false, true, Access::kReadWrite},
    {"TAB_ADDR", "rule that TAB_DATA accesses: 7 j + i", 0x70u, 0, 6, 6, false, true, Access::kReadWrite},
    {"TAB_DATA", "stored rule [2^-20 unit], sign-extended when read; written whole", 0x74u, 0, 32, 24, true, true, Access::kReadWrite},
    {"POS_PRESET", "loads the encoder counter and the command [counts]; not while locked, nor by bytes", 0x78u, 0, 24, 24, true, true, Access::kWrite},
    {"INDEX_LATCH", "count at the last index pulse", 0x7Cu, 0, 32, 24, true, true, Access::kRead},
    {"STROKE_MIN", "lowest allowed position [counts]; locked by LOCK", 0x80u, 0, 24, 24, true, true, Access::kReadWrite},
    {"STROKE_MAX", "highest allowed position [counts]; locked by LOCK", 0x84u, 0, 24, 24, true, true, Access::kReadWrite},
    {"STROKE_EN", "trip when the position leaves the stroke; locked by LOCK", 0x88u, 0, 1, 1, false, true, Access::kReadWrite},
    {"IQ_MANUAL", "current command while the position loop is open [I_fs / 4096]", 0x8Cu, 0, 12, 12, true, true, Access::kReadWrite},
    {"PREC_ADDR", "word of the precision controller that PREC_DATA accesses; counts up behind it", 0x90u, 0, 5, 5, false, true, Access::kReadWrite},
    {"PREC_DATA", "that word; waits until the controller is idle; written whole", 0x94u, 0, 32, 32, true, true, Access::kReadWrite},
    {"PREC_ERR", "error of the precision controller at the last tick [count / 256]", 0x98u, 0, 32, 32, true, true, Access::kRead},
    {"ERR_SUM", "sum of its error over the 32 ticks before the last knot [count / 256]", 0x9Cu, 0, 32, 32, true, true, Access::kRead},
    {"IQ_SUM", "sum of its i_q* over the 32 ticks before the last knot [I_fs / 4096]", 0xA0u, 0, 32, 32, true, true, Access::kRead},
    {"PREC_DIST", "its disturbance at the last knot [2^-26 count per tick^2]", 0xA4u, 0, 32, 32, true, true, Access::kRead},
    {"ANGLE_STEP", "electrical angle of a count [2^-32 revolution]; locked by LOCK", 0xB0u, 0, 32, 32, false, true, Access::kReadWrite},
    {"CURRENT_OFFSET.a", "of phase a [I_fs / 2048]", 0xB4u, 0, 12, 12, true, true, Access::kReadWrite},
    {"CURRENT_OFFSET.b", "of phase b [I_fs / 2048]", 0xB4u, 16, 12, 12, true, true, Access::kReadWrite},
    {"PHASE_CURRENTS.i_a", "current of phase a [I_fs / 2048]", 0xB8u, 0, 16, 12, true, true, Access::kRead},
    {"PHASE_CURRENTS.i_b", "current of phase b [I_fs / 2048]", 0xB8u, 16, 16, 12, true, true, Access::kRead},
    {"ADC_FRAME", "leading zeros; more than 4 act as 4", 0xBCu, 0, 3, 3, false, true, Access::kReadWrite},
    {"ID.version", "identity of the IC and version of its register map", 0x200u, 0, 16, 16, false, false, Access::kRead},
    {"ID.chip", "identity of the IC and version of its register map", 0x200u, 16, 16, 16, false, false, Access::kRead},
    {"COMMIT", "writing 1 makes the next position tick take both POS_CMD, and feeds the watchdog", 0x204u, 0, 1, 1, false, false, Access::kWrite},
    {"IRQ_EN.tick", "interrupt by IRQ_STAT.tick", 0x208u, 0, 1, 1, false, false, Access::kReadWrite},
    {"IRQ_EN.fault", "interrupt by IRQ_STAT.fault", 0x208u, 1, 1, 1, false, false, Access::kReadWrite},
    {"IRQ_STAT.tick", "IRQ_PERIOD ticks have passed", 0x20Cu, 0, 1, 1, false, false, Access::kWriteOneToClear},
    {"IRQ_STAT.fault", "a fault was latched", 0x20Cu, 1, 1, 1, false, false, Access::kWriteOneToClear},
    {"TICK", "position sample counter", 0x210u, 0, 32, 32, false, false, Access::kRead},
    {"FAULT.code", "cause, 1..5; 0 = none", 0x214u, 0, 4, 4, false, false, Access::kRead},
    {"FAULT.axis", "0 X, 1 Y", 0x214u, 4, 1, 1, false, false, Access::kRead},
    {"FAULT.tick", "low 24 bits of TICK at the fault", 0x214u, 8, 24, 24, false, false, Access::kRead},
    {"FAULT_CLEAR", "the key clears the fault if both axes are disabled and the cause is gone", 0x218u, 0, 32, 32, false, false, Access::kWrite},
    {"WATCHDOG", "ticks between COMMITs with an axis enabled; more trip; 0 = off; locked by LOCK", 0x21Cu, 0, 16, 16, false, false, Access::kReadWrite},
    {"LOCK", "lock of limits, dead times, watchdog and presets: write a key; bit 0 reads 1 if so", 0x220u, 0, 32, 1, false, false, Access::kReadWrite},
    {"CURRENT_LIMIT", "trip level of |i_a|, |i_b|, |i_a + i_b| [I_fs / 2048]; 0 = off; locked by LOCK", 0x224u, 0, 12, 12, false, false, Access::kReadWrite},
    {"DEADTIME_MIN", "lowest dead time in effect [clk]; locked by LOCK", 0x228u, 0, 10, 10, false, false, Access::kReadWrite},
    {"IRQ_PERIOD", "position ticks per interrupt; 0 acts as 1", 0x22Cu, 0, 8, 8, false, false, Access::kReadWrite},
    {"KNOT", "knots of the precision controller since it left reset", 0x230u, 0, 32, 32, false, false, Access::kRead},
    {"RATES.carrier", "carrier: 0 16 kHz, 1 8 kHz, 2 20 kHz, 3 40 kHz", 0x240u, 0, 2, 2, false, false, Access::kReadWrite},
    {"RATES.position", "position ticks: 0 1 kHz, 1 2 kHz, 2 4 kHz, 3 acts as 2", 0x240u, 4, 2, 2, false, false, Access::kReadWrite},
}};

// Registers of several fields as one number.
inline constexpr std::array<Field, 3> kWords{{
    {"CTRL", "operating mode of the axis", 0x00u, 0, 9, 9, false, true, Access::kReadWrite},
    {"STATUS", "state of the axis; the sticky bits are cleared by writing 1", 0x04u, 0, 15, 15, false, true, Access::kReadWrite},
    {"FAULT", "first fault since the last clear", 0x214u, 0, 32, 32, false, false, Access::kRead},
}};

}  // namespace trammel::kung_xy_regs
