// SPDX-License-Identifier: Apache-2.0
//
// What the registers of gantry_tau hold after a reset, in numbers.

#include <catch2/catch.hpp>
#include <map>

#include "rtl/chips/generated/gantry_tau_regs.hpp"
#include "tests/chips/gantry_tau_bench.hpp"

namespace reg = trammel::gantry_tau_regs;

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
