// SPDX-License-Identifier: Apache-2.0
//
// The register map of mcafee_xy, version 1, in numbers.

#include <catch2/catch.hpp>
#include <vector>

#include "rtl/chips/generated/mcafee_xy_regs.hpp"
#include "tests/support/register_map.hpp"

namespace reg = trammel::mcafee_xy_regs;

namespace {

const std::vector<trammel::test::Place> kVersion1{
    {"ID.version", 0x000, 15, 0}, {"ID.chip", 0x000, 31, 16},
    {"PORT_B.write_strobe", 0x004, 0, 0}, {"PORT_B.read_strobe", 0x004, 1, 1},
    {"PORT_B.ps", 0x004, 2, 2}, {"PORT_B.read", 0x004, 3, 3}, {"PORT_B.y", 0x004, 4, 4},
    {"PORT_C.to_part", 0x008, 7, 0}, {"PORT_C.from_part", 0x008, 7, 0},
    {"STATUS.busy", 0x00C, 0, 0}, {"STATUS.refused", 0x00C, 1, 1}, {"STATUS.sample", 0x00C, 2, 2},
    {"FEED_IN.c", 0x010, 7, 0}, {"FEED_IN.cc", 0x010, 15, 8}, {"FEED_OUT.v", 0x014, 7, 0},
    {"FEED_OUT.ready", 0x014, 31, 31}, {"IRQ.x", 0x018, 0, 0}, {"IRQ.y", 0x018, 1, 1},
    {"LIMITS.x_low", 0x01C, 0, 0}, {"LIMITS.x_high", 0x01C, 1, 1}, {"LIMITS.y_low", 0x01C, 2, 2},
    {"LIMITS.y_high", 0x01C, 3, 3}, {"RESET", 0x020, 0, 0}};

}  // namespace

TEST_CASE("mcafee_xy has each field of its registers where version 1 of the map has it") {
  CHECK(trammel::test::moved_field(reg::kFields, kVersion1) == "");
  CHECK(trammel::test::other_number(reg::kFields, {}) == "");  // none below 0
  CHECK(reg::kIdValue == 0x4D430001);  // "MC", version 1
}
