// SPDX-License-Identifier: Apache-2.0
//
// What writes of single registers do beside keeping a value, and what they must not do: preset,
// watchdog, sticky bits and pulses, by the byte.
#include <catch2/catch.hpp>

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <vector>

#include "tests/chips/kung_bench.hpp"

namespace reg = trammel::kung_xy_regs;
using trammel::test::KungBench;
using trammel::test::register_name;

namespace {

void write_bytes(KungBench& chip, std::uint32_t address, std::uint32_t data,
                 std::uint32_t strobes) {
  chip->s_axil_wstrb_i = static_cast<std::uint8_t>(strobes);
  chip.write(address, data);
  chip->s_axil_wstrb_i = 15;
}

// Ticks until the watchdog bites while `act` is done once between each two; 0 = not within 8.
int ticks_to_bite(const std::function<void(KungBench&)>& act) {
  KungBench chip;
  chip.write(reg::kWatchdog, 3);
  chip.write(reg::kX + reg::kCtrl, reg::kCtrlEnable);
  chip.leap_to_tick();
  chip.edges(2);
  for (int ticks = 1; ticks <= 8; ++ticks) {
    act(chip);
    chip.leap_to_tick();
    chip.edges(8);
    if (chip.fault_code() == reg::kFaultCodeWatchdog) return ticks;
  }
  return 0;
}

// Registers as they are, every pulse asked for but by the one write that feeds it.
void write_back(KungBench& chip, const reg::Register& one) {
  if (one.address == reg::kCommit) return;
  chip.write(one.address, chip.read(one.address) | one.pulsed | one.cleared);
}

}  // namespace

TEST_CASE("a preset sets the command too, so that the axis does not move when its loop closes") {
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    for (const bool pending : {false, true}) {
      const std::uint32_t other = base == reg::kX ? reg::kY : reg::kX;
      KungBench chip;
      chip.write(base + reg::kPosCmd, 700);
      chip.write(other + reg::kPosCmd, 300);
      chip.write(reg::kCommit, reg::kCommitTake);
      if (!pending) chip.leap_to_tick();
      // The model rests where the axis stands, as a program does before it enables the axis.
      chip.write(base + reg::kCtrl, reg::kCtrlResetModel);
      chip.write(base + reg::kPosPreset, 50000);
      for (int n = 0; n < 2; ++n) chip.leap_to_sample();
      chip.write(base + reg::kCtrl, 0);
      for (int n = 0; n < 6; ++n) {
        chip.leap_to_sample();
        INFO((base == reg::kX ? "X" : "Y") << ", a command pending: " << pending << ", sample "
                                           << n << trammel::test::after_clock(chip.now()));
        CHECK(chip.read_signed(base + reg::kPos) == 50000);
        CHECK(chip.read_signed(base + reg::kPosModel) == 50000);
        CHECK(chip.read_signed(base + reg::kErr) == 0);
      }
      // The other axis has kept its own command and goes there.
      CHECK(chip.read_signed(other + reg::kPos) == 0);
      CHECK(chip.read_signed(other + reg::kPosModel) > 0);
    }
  }
}

TEST_CASE("only a COMMIT with its bit set feeds the watchdog, no other write and no read") {
  CHECK(ticks_to_bite([](KungBench& chip) { chip.write(reg::kCommit, reg::kCommitTake); }) == 0);
  CHECK(ticks_to_bite([](KungBench&) {}) == 3);
  CHECK(ticks_to_bite([](KungBench& chip) { chip.write(reg::kCommit, ~reg::kCommitTake); }) == 3);
  CHECK(ticks_to_bite([](KungBench& chip) { write_bytes(chip, reg::kCommit, ~0u, 0xE); }) == 3);
  CHECK(ticks_to_bite([](KungBench& chip) {
          for (const reg::Register& one : reg::kRegisters) chip.read(one.address);
        }) == 3);
  const int all = ticks_to_bite([](KungBench& chip) {
    for (const reg::Register& one : reg::kRegisters) write_back(chip, one);
  });
  CHECK(all == 3);
  if (all == 3) return;
  for (const reg::Register& one : reg::kRegisters) {  // which of them
    INFO(register_name(reg::kRegisters, one.address) << " is written once a tick");
    CHECK(ticks_to_bite([&](KungBench& chip) { write_back(chip, one); }) == 3);
  }
}

TEST_CASE("a COMMIT takes commands by its own byte only") {
  for (std::uint32_t strobes = 0; strobes < 16; ++strobes) {
    for (const std::uint32_t data : {~0u, ~reg::kCommitTake}) {
      KungBench chip;
      chip.write(reg::kX + reg::kPosCmd, 20000);
      chip.leap_to_tick();
      write_bytes(chip, reg::kCommit, data, strobes);
      for (int n = 0; n < 2; ++n) chip.leap_to_sample();
      CAPTURE(strobes, data);
      CHECK((chip.read_signed(reg::kX + reg::kPosModel) > 0) == ((strobes & data & 1) != 0));
    }
  }
}

TEST_CASE("the rules are reset by a 1 in the lowest byte of CTRL only") {
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    for (std::uint32_t strobes = 0; strobes < 16; ++strobes) {
      KungBench chip;
      chip.write(base + reg::kTabData, 4711);
      chip.leap_to_tick();
      chip.leap_to_sample();
      REQUIRE(chip.read(base + reg::kTabData) == 4711);
      write_bytes(chip, base + reg::kCtrl, ~0u, strobes & 0xE);
      write_bytes(chip, base + reg::kCtrl, reg::kCtrlResetTable, strobes);
      chip.edges(80);
      CAPTURE(base, strobes);
      CHECK((chip.read(base + reg::kTabData) != 4711) == ((strobes & 1) != 0));
    }
  }
}

TEST_CASE("a sticky bit is cleared by a 1 in its byte, and no other bit is") {
  struct Sticky {
    std::uint32_t address, bit;
  };
  const std::vector<Sticky> all{{reg::kX + reg::kStatus, reg::kStatusQepError},
                                {reg::kY + reg::kStatus, reg::kStatusQepError},
                                {reg::kIrqStat, reg::kIrqStatFault},
                                {reg::kIrqStat, reg::kIrqStatTick}};
  KungBench chip;
  const auto sticky_bits = [&](std::uint32_t address) {
    std::uint32_t cleared = 0;
    for (const reg::Register& one : reg::kRegisters) {
      if (one.address == address) cleared = one.cleared;
    }
    return chip.read(address) & cleared;
  };
  int phase = 2;
  for (std::uint32_t strobes = 0; strobes < 16; ++strobes) {
    for (const Sticky& sticky : all) {
      INFO(register_name(reg::kRegisters, sticky.address) << ", bit "
           << trammel::test::number(sticky.bit));
      CAPTURE(strobes);
      for (const int axis : {0, 1}) chip.encoder(axis, phase);
      phase ^= 2;
      chip.edges(20);
      chip.leap_until([&] { return (chip.read(reg::kIrqStat) & reg::kIrqStatTick) != 0; });
      const std::uint32_t before = sticky_bits(sticky.address);
      REQUIRE((before & sticky.bit) != 0);
      chip.write(sticky.address, ~sticky.bit & ~before);
      write_bytes(chip, sticky.address, sticky.bit, strobes);
      const bool cleared = (strobes & 1) != 0;
      CHECK(sticky_bits(sticky.address) == (cleared ? before & ~sticky.bit : before));
      for (const std::uint32_t base : {reg::kX, reg::kY}) chip.write(base + reg::kStatus, ~0u);
      chip.write(reg::kFaultClear, reg::kKeyFaultClear);  // so that the next one is latched
      chip.edges(4);
    }
  }
}

TEST_CASE("the rates keep what is written, but not while an axis is enabled or they are locked") {
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    KungBench chip;
    for (const std::uint32_t rates : {0x23u, 0x01u, 0x32u}) {
      write_bytes(chip, reg::kRates, ~rates, 14);
      chip.write(reg::kRates, rates);
      CHECK(chip.read(reg::kRates) == rates);
    }
    chip.write(base + reg::kCtrl, reg::kCtrlEnable);
    chip.write(reg::kRates, 0x01);
    CHECK(chip.read(reg::kRates) == 0x32);
    chip.write(base + reg::kCtrl, 0);
    chip.write(reg::kRates, 0x01);
    CHECK(chip.read(reg::kRates) == 0x01);
    chip.write(reg::kLock, reg::kKeyLock);
    chip.write(reg::kRates, 0x32);
    CHECK(chip.read(reg::kRates) == 0x01);
  }
}

TEST_CASE("ticks and gates are those of the carrier and of the position rate") {
  constexpr int kPeriods[] = {3125, 6250, 2500, 1250}, kSamples[] = {50000, 25000, 12500};
  for (std::uint32_t carrier = 0; carrier < 4; ++carrier) {
    for (std::uint32_t rate = 0; rate < 3; ++rate) {
      KungBench chip;
      chip.write(reg::kRates, carrier << reg::kRatesCarrierShift |
                                  rate << reg::kRatesPositionShift);
      chip.leap_to_tick();
      chip.leap_to_tick();
      const auto first = chip.now();
      chip.leap_to_tick();
      CAPTURE(carrier, rate);
      CHECK(chip.now() - first == kSamples[rate]);
      // 50 % duty from the second period on; the upper gate of phase a rises once a period.
      chip.write(reg::kX + reg::kCtrl, reg::kCtrlEnable);
      const auto rise = [&] {
        chip.leap_until([&] { return (chip->gate_hi_o & 1) == 0; });
        chip.leap_until([&] { return (chip->gate_hi_o & 1) != 0; });
        return chip.now();
      };
      rise();
      const auto from = rise();
      chip.leap_until([&] { return (chip->gate_hi_o & 1) == 0; });
      const int on = static_cast<int>(chip.now() - from);
      chip.leap_until([&] { return (chip->gate_hi_o & 1) != 0; });
      CHECK(chip.now() - from == kPeriods[carrier]);
      CHECK(std::abs(on + 100 - kPeriods[carrier] / 2) <= 2);  // 100 clocks of dead time
    }
  }
}

TEST_CASE("each bit of IRQ_PERIOD counts") {
  for (const std::uint32_t period : {1u, 2u, 37u, 128u, 255u}) {
    KungBench chip;
    // Ticks of 4 kHz with a carrier of 8 kHz have few clocks in which anything happens.
    if (period > 2) chip.write(reg::kRates, 0x21);
    chip.write(reg::kIrqPeriod, period);
    chip.write(reg::kIrqEn, reg::kIrqEnTick);
    chip.write(reg::kIrqStat, reg::kIrqStatTick);
    chip.leap_until([&] { return chip->irq_o != 0; }, 200000);  // of the reset's period
    chip.write(reg::kIrqStat, reg::kIrqStatTick);
    const std::uint32_t tick = chip.read(reg::kTick);
    chip.leap_until([&] { return chip->irq_o != 0; }, 7'000'000);
    CAPTURE(period);
    CHECK(chip.read(reg::kTick) - tick == period);
  }
}
