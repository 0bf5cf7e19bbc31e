// SPDX-License-Identifier: Apache-2.0
//
// The bus of the chip as its leap contract sees it, and its lock.
#include <catch2/catch.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/chips/kung_bench.hpp"
#include "tests/support/axi_lite.hpp"

namespace reg = trammel::kung_xy_regs;
using trammel::test::KungBench;

namespace {

void to_rest(KungBench& chip) {
  chip.until([&] { return chip->quiescent_o != 0 && chip->next_o > 200; });
}

}  // namespace

TEST_CASE("the chip is quiescent from the end of the last bus transfer on, whatever comes late") {
  for (int n = 0; n < 96; ++n) {
    const bool writes = n % 3 != 0, reads = n % 3 != 1;
    const int data_at = n / 3 % 4, address_at = n / 12 % 4, read_at = n / 48 * 2;
    const int answer_at = n % 7 < 2 ? 0 : n % 7 * 5;  // ready for the responses from then on
    CAPTURE(n);
    KungBench chip;
    to_rest(chip);
    chip->s_axil_awaddr_i = chip->s_axil_araddr_i = reg::kX + reg::kThetaOfs;
    chip->s_axil_wdata_i = 7;
    chip->s_axil_bready_i = chip->s_axil_rready_i = 0;
    int left = int(writes) + int(reads);
    int open = 0;  // accepted addresses; data that come before theirs change nothing
    for (int clock = 0; left > 0; ++clock) {
      REQUIRE(clock < 200);
      if (writes && clock == data_at) chip->s_axil_wvalid_i = 1;
      if (writes && clock == address_at) chip->s_axil_awvalid_i = 1;
      if (reads && clock == read_at) chip->s_axil_arvalid_i = 1;
      if (clock == answer_at + 4) chip->s_axil_bready_i = 1;
      if (clock == answer_at + 4 + n % 5) chip->s_axil_rready_i = 1;
      chip->eval();
      if (open > 0 || chip->s_axil_wvalid_i || chip->s_axil_awvalid_i || chip->s_axil_arvalid_i) {
        REQUIRE_FALSE(chip->quiescent_o);
      }
      const bool aw = chip->s_axil_awvalid_i && chip->s_axil_awready_o;
      const bool ar = chip->s_axil_arvalid_i && chip->s_axil_arready_o;
      const bool w = chip->s_axil_wready_o;
      const int answered = (chip->s_axil_bvalid_o && chip->s_axil_bready_i) +
                           (chip->s_axil_rvalid_o && chip->s_axil_rready_i);
      open += aw + ar - answered;
      left -= answered;
      chip.edge();
      if (aw) chip->s_axil_awvalid_i = 0;
      if (w) chip->s_axil_wvalid_i = 0;
      if (ar) chip->s_axil_arvalid_i = 0;
      chip->eval();
    }
    chip->s_axil_bready_i = chip->s_axil_rready_i = 1;
    chip.edges(2);
    REQUIRE(chip->quiescent_o);
    CHECK(chip.read(reg::kX + reg::kThetaOfs) == (writes ? 7 : 0));
  }
}

TEST_CASE("the chip takes bytes, in any order of the channels, and answers each transfer") {
  KungBench chip;
  const auto clock = [&] {
    chip.edge();
    chip->eval();
  };
  trammel::test::AxiLiteTraffic<KungBench, decltype(clock)> traffic(chip, clock, 61);
  // RATES holds while an axis is enabled.
  const auto registers = trammel::test::kept_registers(reg::kRegisters, {reg::kRates});
  REQUIRE(registers.size() == 50);
  CHECK(wrong_register(traffic, registers, 400, 62) == "");
}

TEST_CASE("a reset leaves in every register the value of the specification") {
  // Section 11; gains are mantissa and exponent. All others are 0.
  const std::map<std::string, std::uint32_t> axis{
      {"KP", 768},              // 0.375, section 4
      {"KI", 25u << 16 | 839},  // 0.0032 = 839 / 2048 2^-7
      {"KV", 1u << 16 | 1884},  {"ETA", 24u << 16 | 1140}, {"SHIFT", 2u << 8},
      {"A0", 238008},           {"B2", 8140683},           {"KP_CUR", 2u << 16 | 1275},
      {"KI_CUR", 30u << 16 | 1478},
      {"DEADTIME", 3u << 16 | 100},  // 2 us, 3 equal samples of an encoder line
      {"STROKE_MAX", 120000},        // 600 mm
      {"ANGLE_STEP", 352047},        // 2^32 / 12 200
      {"ADC_FRAME", 4},              // zeros before 12 bits
  };
  const std::map<std::string, std::uint32_t> system{
      {"ID", 0x4B580005},
      {"CURRENT_LIMIT", 1280},  // 6 A
      {"DEADTIME_MIN", 25},     // 0.5 us
      {"IRQ_PERIOD", 4},
      {"RATES", 0x10},  // 16 kHz, 2 kHz
  };
  KungBench chip;
  for (const reg::Register& one : reg::kRegisters) {
    const std::string name = one.name;
    const std::string own = name.substr(name.find('.') + 1);
    // Rule 0 of the table; what the first tick has done.
    if (own == "TAB_DATA" || own == "TICK" || own == "IRQ_STAT") continue;
    const auto& values = own == name ? system : axis;
    const auto found = values.find(own);
    CAPTURE(name);
    CHECK(chip.read(one.address) == (found == values.end() ? 0 : found->second));
  }
}

TEST_CASE("many transfers leave none open, and only the two keys change the lock") {
  KungBench chip;
  for (int n = 0; n < 32; ++n) {
    chip.write(reg::kY + reg::kThetaOfs, 1u << n);
    REQUIRE(chip.read(reg::kY + reg::kThetaOfs) == 1u << n);
    for (const std::uint32_t key : {reg::kKeyLock, reg::kKeyUnlock}) {
      chip.write(reg::kLock, key);
      const bool locked = key == reg::kKeyLock;
      REQUIRE(chip.read(reg::kLock) == (locked ? 1u : 0u));
      chip.write(reg::kLock, (locked ? reg::kKeyUnlock : reg::kKeyLock) ^ 1u << n);
      REQUIRE(chip.read(reg::kLock) == (locked ? 1u : 0u));
      chip.read(reg::kTick);
      REQUIRE(chip.read(reg::kLock) == (locked ? 1u : 0u));
    }
  }
  to_rest(chip);
}

TEST_CASE("only a write of the whole key clears a fault, and a read of its register does not") {
  KungBench chip;
  chip->trip_i = 1;
  chip.edges(5);
  chip->trip_i = 0;
  chip.edges(5);
  for (int n = 0; n < 32; ++n) {
    chip.write(reg::kFaultClear, reg::kKeyFaultClear ^ 1u << n);
    REQUIRE(chip.fault_code() == reg::kFaultCodeExternalTrip);
  }
  chip.write(reg::kX + reg::kThetaOfs, reg::kKeyFaultClear);  // to another register
  chip.write(reg::kLock, reg::kKeyFaultClear);
  REQUIRE(chip.fault_code() == reg::kFaultCodeExternalTrip);
  REQUIRE(chip.read(reg::kFault) >> reg::kFaultTickShift == 1);  // the tick count of the trip
  chip.write(reg::kFaultClear, reg::kKeyFaultClear);
  REQUIRE(chip.fault_code() == reg::kFaultCodeNone);
}

TEST_CASE("a key, a preset or a rule of which only some bytes are written does nothing") {
  KungBench chip;
  const auto in_part = [&chip](unsigned strobes, std::uint32_t address, std::uint32_t data) {
    chip->s_axil_wstrb_i = static_cast<std::uint8_t>(strobes);
    chip.write(address, data);
    chip->s_axil_wstrb_i = 0xF;
  };
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    chip.write(base + reg::kPosPreset, 700);
    chip.write(base + reg::kTabData, 0x123456);
  }
  chip->trip_i = 1;
  chip.edges(5);
  chip->trip_i = 0;
  chip.edges(5);
  for (unsigned strobes = 0; strobes < 15; ++strobes) {
    CAPTURE(strobes);
    in_part(strobes, reg::kFaultClear, reg::kKeyFaultClear);
    REQUIRE(chip.fault_code() == reg::kFaultCodeExternalTrip);
    in_part(strobes, reg::kLock, reg::kKeyLock);
    REQUIRE(chip.read(reg::kLock) == 0);
    chip.write(reg::kLock, reg::kKeyLock);
    in_part(strobes, reg::kLock, reg::kKeyUnlock);
    REQUIRE(chip.read(reg::kLock) == 1);
    chip.write(reg::kLock, reg::kKeyUnlock);
    for (const std::uint32_t base : {reg::kX, reg::kY}) {
      in_part(strobes, base + reg::kTabData, 0x654321);
      REQUIRE(chip.read(base + reg::kTabData) == 0x123456);
      if ((strobes & 7) != 7) in_part(strobes, base + reg::kPosPreset, 9);
    }
  }
  chip.to_tick();
  chip.edges(5);
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    CHECK(chip.read(base + reg::kPos) == 700);
    in_part(7, base + reg::kPosPreset, 9);  // it has three bytes
  }
  chip.to_tick();
  chip.edges(5);
  for (const std::uint32_t base : {reg::kX, reg::kY}) CHECK(chip.read(base + reg::kPos) == 9);
}

TEST_CASE("each interrupt comes only through its own enable") {
  for (const std::uint32_t enabled : {0u, reg::kIrqEnTick, reg::kIrqEnFault, 3u}) {
    for (const std::uint32_t cause : {0u, reg::kIrqStatTick, reg::kIrqStatFault, 3u}) {
      CAPTURE(enabled, cause);
      KungBench own;
      REQUIRE(own.read(reg::kIrqStat) == reg::kIrqStatTick);  // of the first tick
      if ((cause & reg::kIrqStatFault) != 0) {
        own->trip_i = 1;
        own.edges(5);
        own->trip_i = 0;
      }
      own.write(reg::kIrqStat, ~cause & 3);
      own.write(reg::kIrqEn, enabled);
      REQUIRE(own.read(reg::kIrqStat) == cause);
      REQUIRE(own->irq_o == ((enabled & cause) != 0));
    }
  }
}

TEST_CASE("the sample waits for the axis whose table reset delays it, and comes once") {
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    KungBench chip;
    chip.to_tick();
    chip.edges(25000 - 20);
    chip.write(base + reg::kCtrl, reg::kCtrlResetTable);  // 50 clocks, of which some are left
    int ticks = 0, samples = 0, latency = 0;
    for (int clock = 0; clock < 1000; ++clock) {
      if (chip->tick_o != 0) ticks = clock + 1;
      if (chip->sample_o != 0) {
        ++samples;
        latency = clock + 1 - ticks;
      }
      chip.edge();
    }
    REQUIRE(ticks > 0);
    REQUIRE(samples == 1);
    REQUIRE(latency > 75);
    REQUIRE(latency < 71 + 50);
    REQUIRE(chip.to_sample() > 20000);
  }
}
