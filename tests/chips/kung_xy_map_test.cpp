// SPDX-License-Identifier: Apache-2.0
//
// The register map of kung_xy, version 5, in numbers.

#include <catch2/catch.hpp>
#include <vector>

#include "rtl/chips/generated/kung_xy_regs.hpp"
#include "tests/support/register_map.hpp"

namespace reg = trammel::kung_xy_regs;

namespace {

// Addresses of X and Y are offsets.
const std::vector<trammel::test::Place> kVersion5{
    {"CTRL.enable", 0x000, 0, 0}, {"CTRL.current_loop", 0x000, 1, 1},
    {"CTRL.position_loop", 0x000, 2, 2}, {"CTRL.adapt", 0x000, 3, 3},
    {"CTRL.reset_model", 0x000, 4, 4}, {"CTRL.reset_table", 0x000, 5, 5},
    {"CTRL.interpolate", 0x000, 6, 6}, {"CTRL.feedforward", 0x000, 7, 7},
    {"CTRL.precision", 0x000, 8, 8},
    {"STATUS.busy", 0x004, 0, 0}, {"STATUS.overrun", 0x004, 1, 1},
    {"STATUS.qep_error", 0x004, 2, 2}, {"STATUS.saturated", 0x004, 3, 3},
    {"STATUS.limited", 0x004, 4, 4}, {"STATUS.underrun", 0x004, 5, 5},
    {"STATUS.clipped", 0x004, 6, 6}, {"STATUS.step", 0x004, 14, 8}, {"POS_CMD", 0x008, 23, 0},
    {"POS", 0x00C, 31, 0}, {"POS_MODEL", 0x010, 31, 0}, {"ERR", 0x014, 31, 0},
    {"DERR", 0x018, 31, 0}, {"U", 0x01C, 31, 0}, {"VSTAR", 0x020, 31, 0},
    {"IQ_CMD", 0x024, 31, 0}, {"SPEED", 0x028, 31, 0}, {"ID_IQ.i_d", 0x02C, 15, 0},
    {"ID_IQ.i_q", 0x02C, 31, 16}, {"VD_VQ.v_d", 0x030, 15, 0}, {"VD_VQ.v_q", 0x030, 31, 16},
    {"KP.mant", 0x040, 10, 0}, {"KP.exp", 0x040, 20, 16}, {"KI.mant", 0x044, 10, 0},
    {"KI.exp", 0x044, 20, 16}, {"KV.mant", 0x048, 10, 0}, {"KV.exp", 0x048, 20, 16},
    {"ETA.mant", 0x04C, 10, 0}, {"ETA.exp", 0x04C, 20, 16}, {"SHIFT.e", 0x050, 4, 0},
    {"SHIFT.de", 0x050, 12, 8}, {"A0.value", 0x054, 17, 0},
    {"A0.scale", 0x054, 21, 20}, {"B2", 0x058, 23, 0},
    {"KP_CUR.mant", 0x060, 10, 0}, {"KP_CUR.exp", 0x060, 20, 16}, {"KI_CUR.mant", 0x064, 10, 0},
    {"KI_CUR.exp", 0x064, 20, 16}, {"THETA_OFS", 0x068, 31, 0}, {"DEADTIME.clk", 0x06C, 9, 0},
    {"DEADTIME.qep_filter", 0x06C, 19, 16}, {"TAB_ADDR", 0x070, 5, 0}, {"TAB_DATA", 0x074, 31, 0},
    {"POS_PRESET", 0x078, 23, 0}, {"INDEX_LATCH", 0x07C, 31, 0}, {"STROKE_MIN", 0x080, 23, 0},
    {"STROKE_MAX", 0x084, 23, 0}, {"STROKE_EN", 0x088, 0, 0}, {"IQ_MANUAL", 0x08C, 11, 0},
    {"PREC_ADDR", 0x090, 4, 0}, {"PREC_DATA", 0x094, 31, 0}, {"PREC_ERR", 0x098, 31, 0},
    {"ERR_SUM", 0x09C, 31, 0}, {"IQ_SUM", 0x0A0, 31, 0}, {"PREC_DIST", 0x0A4, 31, 0},
    {"ANGLE_STEP", 0x0B0, 31, 0}, {"CURRENT_OFFSET.a", 0x0B4, 11, 0},
    {"CURRENT_OFFSET.b", 0x0B4, 27, 16}, {"PHASE_CURRENTS.i_a", 0x0B8, 15, 0},
    {"PHASE_CURRENTS.i_b", 0x0B8, 31, 16}, {"ADC_FRAME", 0x0BC, 2, 0},
    {"ID.version", 0x200, 15, 0}, {"ID.chip", 0x200, 31, 16}, {"COMMIT", 0x204, 0, 0},
    {"IRQ_EN.tick", 0x208, 0, 0}, {"IRQ_EN.fault", 0x208, 1, 1}, {"IRQ_STAT.tick", 0x20C, 0, 0},
    {"IRQ_STAT.fault", 0x20C, 1, 1}, {"TICK", 0x210, 31, 0}, {"FAULT.code", 0x214, 3, 0},
    {"FAULT.axis", 0x214, 4, 4}, {"FAULT.tick", 0x214, 31, 8}, {"FAULT_CLEAR", 0x218, 31, 0},
    {"WATCHDOG", 0x21C, 15, 0}, {"LOCK", 0x220, 31, 0}, {"CURRENT_LIMIT", 0x224, 11, 0},
    {"DEADTIME_MIN", 0x228, 9, 0}, {"IRQ_PERIOD", 0x22C, 7, 0},
    {"KNOT", 0x230, 31, 0}, {"RATES.carrier", 0x240, 1, 0}, {"RATES.position", 0x240, 5, 4}};

const std::vector<trammel::test::Number> kNumbers5{
    {"POS_CMD", 24}, {"POS", 24}, {"POS_MODEL", 24}, {"ERR", 12}, {"DERR", 12}, {"U", 12},
    {"VSTAR", 12}, {"IQ_CMD", 12}, {"SPEED", 12}, {"ID_IQ.i_d", 12}, {"ID_IQ.i_q", 12},
    {"VD_VQ.v_d", 12}, {"VD_VQ.v_q", 12}, {"KP.exp", 5}, {"KI.exp", 5}, {"KV.exp", 5},
    {"ETA.exp", 5}, {"SHIFT.e", 5}, {"SHIFT.de", 5}, {"B2", 24}, {"KP_CUR.exp", 5},
    {"KI_CUR.exp", 5}, {"TAB_DATA", 24},
    {"POS_PRESET", 24}, {"INDEX_LATCH", 24}, {"STROKE_MIN", 24}, {"STROKE_MAX", 24},
    {"IQ_MANUAL", 12}, {"PREC_DATA", 32}, {"PREC_ERR", 32}, {"ERR_SUM", 32}, {"IQ_SUM", 32},
    {"PREC_DIST", 32}, {"CURRENT_OFFSET.a", 12}, {"CURRENT_OFFSET.b", 12},
    {"PHASE_CURRENTS.i_a", 12}, {"PHASE_CURRENTS.i_b", 12}, {"LOCK", 1, false}};

}  // namespace

TEST_CASE("kung_xy has each field of its registers where version 5 of the map has it") {
  CHECK(trammel::test::moved_field(reg::kFields, kVersion5) == "");
  CHECK(trammel::test::other_number(reg::kFields, kNumbers5) == "");
  CHECK(reg::kX == 0x000);
  CHECK(reg::kY == 0x100);
  CHECK(reg::kIdValue == 0x4B580005);  // "KX", version 5
  CHECK(reg::kKeyLock == 0x4C4F434B);  // "LOCK"
  CHECK(reg::kKeyUnlock == 0x554E4C4B);  // "UNLK"
  CHECK(reg::kKeyFaultClear == 0x434C5246);  // "CLRF"
  CHECK(reg::kFaultCodeExternalTrip == 1);
  CHECK(reg::kFaultCodeOverCurrent == 2);
  CHECK(reg::kFaultCodeWatchdog == 3);
  CHECK(reg::kFaultCodeEncoder == 4);
  CHECK(reg::kFaultCodeStroke == 5);
}
