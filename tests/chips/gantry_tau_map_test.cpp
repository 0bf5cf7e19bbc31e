// SPDX-License-Identifier: Apache-2.0
//
// The register map of gantry_tau, version 1, and what its registers hold after a reset, in numbers.

#include <catch2/catch.hpp>
#include <map>
#include <vector>

#include "rtl/chips/generated/gantry_tau_regs.hpp"
#include "tests/chips/gantry_tau_bench.hpp"
#include "tests/support/register_map.hpp"

namespace reg = trammel::gantry_tau_regs;

namespace {

const std::vector<trammel::test::Place> kVersion1{
    {"ID.version", 0x000, 15, 0}, {"ID.chip", 0x000, 31, 16}, {"OBSERVER.active", 0x004, 0, 0},
    {"OBSERVER.velocity", 0x004, 4, 4}, {"POSITION", 0x008, 31, 0}, {"VELOCITY", 0x00C, 31, 0},
    {"ANGLE.phase", 0x010, 13, 0}, {"ANGLE.region", 0x010, 17, 16}, {"ANGLE.known", 0x010, 31, 31},
    {"TICKS", 0x014, 31, 0}, {"SLOTS.observer", 0x018, 7, 0}, {"SLOTS.requester", 0x018, 23, 16},
    {"REQUEST.a", 0x01C, 0, 0}, {"REQUEST.pending", 0x01C, 6, 0}, {"REQUEST.a_dot", 0x01C, 1, 1},
    {"REQUEST.b", 0x01C, 2, 2}, {"REQUEST.b_dot", 0x01C, 3, 3}, {"REQUEST.current", 0x01C, 6, 6},
    {"ENCODER_A.code", 0x020, 9, 0}, {"ENCODER_A.dot", 0x020, 25, 16},
    {"ENCODER_B.code", 0x024, 9, 0}, {"ENCODER_B.dot", 0x024, 25, 16}, {"CURRENT", 0x028, 9, 0},
    {"FORCE_1", 0x02C, 10, 0}, {"FORCE_2", 0x030, 10, 0}, {"OVERTEMP.motor_1", 0x034, 0, 0},
    {"OVERTEMP.motor_2", 0x034, 1, 1}, {"PASS_PERIOD", 0x038, 23, 0}, {"STATUS.pass", 0x03C, 0, 0},
    {"STATUS.frame", 0x03C, 1, 1}, {"STATUS.sample", 0x03C, 2, 2}, {"STATUS.overrun", 0x03C, 3, 3},
    {"STATUS.refused", 0x03C, 4, 4}, {"STATUS.stored", 0x03C, 5, 5},
    {"IRQ_ENABLE.pass", 0x040, 0, 0}, {"IRQ_ENABLE.frame", 0x040, 1, 1},
    {"IRQ_ENABLE.sample", 0x040, 2, 2}, {"RECEIVE.channel", 0x044, 4, 0},
    {"RECEIVE.take", 0x044, 0, 0}, {"RECEIVE.kind", 0x044, 10, 8},
    {"RECEIVE.waits", 0x044, 31, 31}, {"RECEIVE_VALUE", 0x048, 31, 0},
    {"RECEIVE_ERRORS.malformed", 0x04C, 15, 0}, {"RECEIVE_ERRORS.lost", 0x04C, 31, 16},
    {"SEND_VALUE", 0x050, 31, 0}, {"SEND.channel", 0x054, 4, 0}, {"SEND.kind", 0x054, 10, 8},
    {"SEND_STATE.room", 0x058, 5, 0}, {"SEND_STATE.idle", 0x058, 8, 8},
    {"SEND_STATE.lost", 0x058, 31, 16}, {"CALIBRATE.word", 0x05C, 15, 0},
    {"CALIBRATE.command", 0x05C, 18, 16}, {"CALIBRATION.valid", 0x060, 0, 0},
    {"CALIBRATION.busy", 0x060, 1, 1}, {"CALIBRATION.count", 0x060, 13, 8},
    {"RECEIVE_GAP", 0x064, 23, 0}};

}  // namespace

TEST_CASE("gantry_tau has each field of its registers where version 1 of the map has it") {
  CHECK(trammel::test::moved_field(reg::kFields, kVersion1) == "");
  CHECK(trammel::test::other_number(reg::kFields, {{"POSITION", 32}, {"VELOCITY", 23},
                                                   {"FORCE_1", 11}, {"FORCE_2", 11}}) == "");
}

TEST_CASE("gantry_tau: a reset leaves in every register the value of its page") {
  const std::map<std::uint32_t, std::uint32_t> values{  // all others are 0
      {0x000, 0x47540001},  // ID: "GT", version 1
      {0x018, 0x00010002},  // SLOTS: two of the observer, one of the requester
      {0x038, 100'000},     // PASS_PERIOD: 2 ms
      {0x054, 0x00000400},  // SEND: a value
      {0x058, 0x00000120},  // SEND_STATE: at rest, room for 32
      {0x064, 504'774},     // RECEIVE_GAP: 10 ms and a byte
  };
  trammel::test::GantryBench chip;
  chip.clocks(200);  // the empty memory has been read and refused
  CHECK(chip.get(reg::kCalibration) >> 8 == 63);
  chip.put(reg::kStatus, reg::kStatusRefused);
  for (const reg::Register& one : reg::kRegisters) {
    if (one.address == reg::kCalibration) continue;
    const auto found = values.find(one.address);
    INFO(trammel::test::register_name(reg::kRegisters, one.address));
    CHECK(chip.get(one.address) == (found == values.end() ? 0 : found->second));
  }
}
