// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <cstdint>
#include <vector>

#include "tests/chips/kung_bench.hpp"

namespace reg = trammel::kung_xy_regs;
using trammel::test::KungBench;

namespace {

void disable_and_clear(KungBench& chip) {
  chip.write(reg::kX + reg::kCtrl, 0);
  chip.write(reg::kY + reg::kCtrl, 0);
  chip.write(reg::kFaultClear, reg::kKeyFaultClear);
}

// Clocks of each state of X phase A over some periods: {gate, length}, gate 'h', 'l' or '0'.
struct Span {
  char gate;
  int length;
};

std::vector<Span> spans(KungBench& chip, int clocks) {
  std::vector<Span> out;
  for (int i = 0; i < clocks; ++i) {
    chip.edge();
    const char gate = (chip->gate_hi_o & 1) != 0 ? 'h' : (chip->gate_lo_o & 1) != 0 ? 'l' : '0';
    if (out.empty() || out.back().gate != gate) out.push_back({gate, 0});
    ++out.back().length;
  }
  out.erase(out.begin());
  out.pop_back();
  return out;
}

}  // namespace

TEST_CASE("the chip reports its ID and its reset values") {
  KungBench chip;
  CHECK(chip.read(reg::kId) == reg::kIdValue);
  CHECK(chip.read(reg::kX + reg::kCtrl) == 0);
  CHECK(chip.read(reg::kY + reg::kKp) == 768);
  CHECK(chip.read(reg::kY + reg::kKi) == (0x190000u | 839u));  // exponent -7
  CHECK(chip.read(reg::kX + reg::kA0) == 238008);
  CHECK(chip.read(reg::kX + reg::kB2) == 8140683);
  CHECK(chip.read(reg::kX + reg::kDeadtime) == (100u | 3u << reg::kDeadtimeQepFilterShift));
  CHECK(chip.read(reg::kLock) == 0);
  CHECK(chip.fault_code() == reg::kFaultCodeNone);
  chip.write(reg::kY + reg::kThetaOfs, 0xdeadbeef);
  CHECK(chip.read(reg::kY + reg::kThetaOfs) == 0xdeadbeef);
  CHECK(chip.read(reg::kX + reg::kThetaOfs) == 0);
}

TEST_CASE("an enabled axis with open loops switches at 50 % and exactly 16 kHz with dead time") {
  KungBench chip;
  chip.write(reg::kX + reg::kCtrl, reg::kCtrlEnable);
  chip.edges(2 * 3125);
  const std::vector<Span> seen = spans(chip, 4 * 3125);
  REQUIRE(seen.size() >= 12);
  for (const Span& span : seen) {
    // On from carrier 782 to 782: 1562 clocks of 3125, each side shortened by the dead time.
    CHECK(span.length == (span.gate == 'h' ? 1562 - 100 : span.gate == 'l' ? 1563 - 100 : 100));
  }
  CHECK((chip->gate_hi_o >> 3) == 0);  // Y stays off
  CHECK((chip->gate_lo_o >> 3) == 0);
}

TEST_CASE("the dead time in effect is never below DEADTIME_MIN") {
  KungBench chip;
  chip.write(reg::kX + reg::kDeadtime, 5u | 3u << reg::kDeadtimeQepFilterShift);
  chip.write(reg::kDeadtimeMin, 40);
  chip.write(reg::kX + reg::kCtrl, reg::kCtrlEnable);
  chip.edges(2 * 3125);
  for (const Span& span : spans(chip, 2 * 3125)) {
    if (span.gate == '0') CHECK(span.length == 40);
  }
}

TEST_CASE("while locked, limits, strokes, dead time, watchdog, angle and sensors cannot be set") {
  KungBench chip;
  chip.write(reg::kX + reg::kCtrl, reg::kCtrlEnable);
  chip.write(reg::kLock, 1);  // not the key
  CHECK(chip.read(reg::kLock) == 0);
  chip.write(reg::kLock, reg::kKeyLock);
  CHECK(chip.read(reg::kLock) == 1);

  const std::vector<std::uint32_t> guarded{
      reg::kCurrentLimit,           reg::kDeadtimeMin,           reg::kX + reg::kStrokeMin,
      reg::kY + reg::kStrokeMax,    reg::kX + reg::kStrokeEn,    reg::kY + reg::kStrokeMin,
      reg::kWatchdog,               reg::kX + reg::kAngleStep,   reg::kY + reg::kAngleStep,
      reg::kX + reg::kCurrentOffset, reg::kY + reg::kCurrentOffset,
      reg::kX + reg::kAdcFrame,     reg::kY + reg::kAdcFrame,
      reg::kX + reg::kStrokeMax,    reg::kY + reg::kStrokeEn};
  for (const std::uint32_t addr : guarded) {
    INFO(trammel::test::register_name(reg::kRegisters, addr));
    const std::uint32_t before = chip.read(addr);
    chip.write(addr, ~before);  // every field: each has its own lock
    CHECK(chip.read(addr) == before);
  }
  chip.write(reg::kX + reg::kDeadtime, 200u | 5u << reg::kDeadtimeQepFilterShift);
  CHECK(chip.read(reg::kX + reg::kDeadtime) == (100u | 5u << reg::kDeadtimeQepFilterShift));

  chip.write(reg::kLock, reg::kKeyUnlock);
  CHECK(chip.read(reg::kLock) == 1);  // an axis is enabled
  chip.write(reg::kX + reg::kCtrl, 0);
  chip.write(reg::kLock, reg::kKeyUnlock);
  CHECK(chip.read(reg::kLock) == 0);
  for (const std::uint32_t addr : guarded) {
    INFO(trammel::test::register_name(reg::kRegisters, addr));
    const std::uint32_t before = chip.read(addr);
    chip.write(addr, before ^ 1u);
    CHECK(chip.read(addr) == (before ^ 1u));
  }
}

TEST_CASE("the trip pin turns all gates off 4 clocks later and stays latched until cleared") {
  KungBench chip;
  chip.write(reg::kX + reg::kCtrl, reg::kCtrlEnable);
  chip.write(reg::kY + reg::kCtrl, reg::kCtrlEnable);
  chip.write(reg::kIrqEn, reg::kIrqEnFault);
  chip.edges(3 * 3125);
  chip.until([&] { return (chip->gate_hi_o | chip->gate_lo_o) == 0x3f; });
  chip->trip_i = 1;
  chip.edges(3);
  CHECK_FALSE(chip.gates_off());
  chip.edge();
  CHECK(chip.gates_off());
  chip->trip_i = 0;
  for (int i = 0; i < 4000; ++i) {
    chip.edge();
    REQUIRE(chip.gates_off());
  }
  CHECK(chip->irq_o == 1);
  CHECK(chip.read(reg::kIrqStat) >= reg::kIrqStatFault);
  chip.write(reg::kIrqStat, reg::kIrqStatFault);
  CHECK(chip->irq_o == 0);
  CHECK(chip.fault_code() == reg::kFaultCodeExternalTrip);

  chip.write(reg::kFaultClear, reg::kKeyFaultClear);  // both axes still enabled
  CHECK(chip.fault_code() == reg::kFaultCodeExternalTrip);
  chip.write(reg::kX + reg::kCtrl, 0);
  chip.write(reg::kY + reg::kCtrl, 0);
  chip.write(reg::kFaultClear, reg::kKeyFaultClear ^ 1u);
  CHECK(chip.fault_code() == reg::kFaultCodeExternalTrip);
  chip->trip_i = 1;
  chip.edges(10);
  chip.write(reg::kFaultClear, reg::kKeyFaultClear);  // the cause is still there
  CHECK(chip.fault_code() == reg::kFaultCodeExternalTrip);
  chip->trip_i = 0;
  chip.edges(10);
  chip.write(reg::kFaultClear, reg::kKeyFaultClear);
  CHECK(chip.fault_code() == reg::kFaultCodeNone);
  chip.write(reg::kX + reg::kCtrl, reg::kCtrlEnable);
  chip.until([&] { return !chip.gates_off(); });
}

TEST_CASE("the watchdog trips when COMMITs stay away for its limit of ticks") {
  KungBench chip;
  chip.write(reg::kWatchdog, 3);
  chip.write(reg::kX + reg::kCtrl, reg::kCtrlEnable);
  for (int tick = 0; tick < 6; ++tick) {
    chip.leap_to_tick();
    chip.edges(2);
    chip.write(reg::kCommit, reg::kCommitTake);
  }
  CHECK(chip.fault_code() == reg::kFaultCodeNone);
  for (int tick = 0; tick < 3; ++tick) chip.leap_to_tick();
  chip.edges(10);
  CHECK(chip.fault_code() == reg::kFaultCodeNone);
  chip.leap_to_tick();
  chip.edges(10);
  CHECK(chip.fault_code() == reg::kFaultCodeWatchdog);
  CHECK(chip.gates_off());
  disable_and_clear(chip);
  CHECK(chip.fault_code() == reg::kFaultCodeNone);
}

TEST_CASE("over-current trips at CURRENT_LIMIT, in the third phase too, and names the axis") {
  KungBench chip;
  chip.write(reg::kCurrentLimit, 500);
  chip.write(reg::kY + reg::kCtrl, reg::kCtrlEnable);
  chip.codes[1] = {2048 + 499, 2048 - 300};
  chip.edges(2 * 3125);
  CHECK(chip.fault_code() == reg::kFaultCodeNone);
  chip.codes[1] = {2048 - 250, 2048 - 250};
  chip.edges(3125 + 100);
  CHECK(chip.fault_code() == reg::kFaultCodeOverCurrent);
  CHECK((chip.read(reg::kFault) & reg::kFaultAxis) != 0);
  CHECK(chip.gates_off());
  disable_and_clear(chip);
  CHECK(chip.fault_code() == reg::kFaultCodeOverCurrent);  // the last conversion still exceeds it
  chip.codes[1] = {};
  chip.edges(3125 + 100);
  disable_and_clear(chip);
  CHECK(chip.fault_code() == reg::kFaultCodeNone);
}

TEST_CASE("an encoder error trips and is cleared through STATUS first") {
  KungBench chip;
  chip.encoder(0, 2);  // A and B at once
  chip.edges(20);
  CHECK((chip.read(reg::kX + reg::kStatus) & reg::kStatusQepError) != 0);
  CHECK((chip.read(reg::kY + reg::kStatus) & reg::kStatusQepError) == 0);
  CHECK(chip.fault_code() == reg::kFaultCodeEncoder);
  CHECK((chip.read(reg::kFault) & reg::kFaultAxis) == 0);
  disable_and_clear(chip);
  CHECK(chip.fault_code() == reg::kFaultCodeEncoder);
  chip.write(reg::kX + reg::kStatus, reg::kStatusQepError);
  CHECK((chip.read(reg::kX + reg::kStatus) & reg::kStatusQepError) == 0);
  disable_and_clear(chip);
  CHECK(chip.fault_code() == reg::kFaultCodeNone);
}

TEST_CASE("while locked a preset moves no count, so that it cannot lead past the stroke limits") {
  KungBench chip;
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    chip.write(base + reg::kPosPreset, 1000);
    chip.write(base + reg::kStrokeEn, reg::kStrokeEnEnable);
    chip.write(base + reg::kStrokeMax, 1002);
  }
  chip.write(reg::kLock, reg::kKeyLock);
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    chip.write(base + reg::kPosPreset, 200);
    chip.leap_to_sample();
    CHECK(chip.read_signed(base + reg::kPos) == 1000);
  }
  for (const int phase : {1, 2, 3}) {  // 1001, 1002, 1003
    CHECK(chip.fault_code() == reg::kFaultCodeNone);
    chip.encoder(0, phase);
    chip.edges(20);
  }
  CHECK(chip.fault_code() == reg::kFaultCodeStroke);
  disable_and_clear(chip);
  chip.write(reg::kLock, reg::kKeyUnlock);
  chip.write(reg::kX + reg::kPosPreset, 200);
  chip.leap_to_sample();
  CHECK(chip.read_signed(reg::kX + reg::kPos) == 200);
}

TEST_CASE("POS_PRESET loads the counter and leaving an enabled stroke trips") {
  KungBench chip;
  chip.write(reg::kX + reg::kPosPreset, 119999);
  chip.write(reg::kY + reg::kPosPreset, 0xffff00);
  chip.write(reg::kX + reg::kStrokeEn, reg::kStrokeEnEnable);
  chip.to_sample();
  CHECK(chip.read_signed(reg::kX + reg::kPos) == 119999);
  CHECK(chip.read_signed(reg::kY + reg::kPos) == -256);
  chip.encoder(0, 1);
  chip.edges(20);
  CHECK(chip.fault_code() == reg::kFaultCodeNone);  // 120000 is inside
  chip.encoder(0, 2);
  chip.edges(20);
  CHECK(chip.fault_code() == reg::kFaultCodeStroke);
  chip.to_sample();
  CHECK(chip.read_signed(reg::kX + reg::kPos) == 120001);
}

TEST_CASE("COMMIT takes both commands at the next 2 kHz tick and the model answers as specified") {
  KungBench chip;
  chip.leap_to_sample();
  chip.write(reg::kX + reg::kPosCmd, 2000);
  chip.write(reg::kY + reg::kPosCmd, static_cast<std::uint32_t>(-2000));
  chip.leap_to_sample();
  CHECK(chip.read_signed(reg::kX + reg::kPosModel) == 0);
  chip.write(reg::kCommit, reg::kCommitTake);
  const std::vector<int> x_r{0, 1, 1, 3};  // 1816, 9025, 23282, 44376 of section 4, in counts
  for (const int expected : x_r) {
    chip.leap_to_sample();
    CHECK(chip.read_signed(reg::kX + reg::kPosModel) == expected);
    CHECK(chip.read_signed(reg::kY + reg::kPosModel) == -expected);
  }
  for (int k = 4; k <= 9; ++k) chip.leap_to_sample();
  CHECK(chip.read_signed(reg::kX + reg::kPosModel) == 19);  // 303263
  CHECK(chip.read_signed(reg::kX + reg::kErr) == 19);
}

TEST_CASE("the interrupt comes every IRQ_PERIOD ticks and its cause is cleared by writing one") {
  KungBench chip;
  chip.write(reg::kIrqStat, reg::kIrqStatTick);
  chip.write(reg::kIrqEn, reg::kIrqEnTick);
  CHECK(chip->irq_o == 0);
  chip.until([&] { return chip->irq_o != 0; });
  const std::int64_t first = chip.now();
  const std::uint32_t tick = chip.read(reg::kTick);
  CHECK(chip.read(reg::kIrqStat) == reg::kIrqStatTick);
  chip.write(reg::kIrqStat, reg::kIrqStatFault);
  CHECK(chip->irq_o == 1);
  chip.write(reg::kIrqStat, reg::kIrqStatTick);
  CHECK(chip->irq_o == 0);
  chip.until([&] { return chip->irq_o != 0; });
  CHECK(chip.now() - first == 100000);  // 2 ms
  CHECK(chip.read(reg::kTick) == tick + 4);
}

TEST_CASE("the sample is complete 71 clocks after the tick, every 25 000 clocks") {
  KungBench chip;
  chip.to_sample();
  const std::int64_t sample = chip.now();
  CHECK(chip.to_tick() == 25000 - 71);
  const int latency = chip.to_sample();
  CHECK(latency == 71);
  CHECK(chip.now() - sample == 25000);
}

TEST_CASE("the current loop is done at most 96 clocks after the last converter bit") {
  KungBench chip;
  chip.write(reg::kX + reg::kCtrl, reg::kCtrlEnable | reg::kCtrlCurrentLoop);
  chip.to_tick();
  chip.until([&] { return chip->adc_cs_n_o == 0; });
  chip.until([&] { return chip->adc_cs_n_o == 3; });
  const int clocks = chip.until([&] { return chip->quiescent_o != 0; });
  CHECK(clocks <= 96);
  CHECK(clocks > 60);
}

TEST_CASE("a closed current loop at standstill gives the voltages of section 7") {
  KungBench chip;
  chip.write(reg::kX + reg::kIqManual, 427);
  chip.to_tick();
  chip.edges(1000);
  chip.write(reg::kX + reg::kCtrl, reg::kCtrlEnable | reg::kCtrlCurrentLoop);
  for (const int v_q : {1063, 1140, 1217, 1294}) {
    chip.edges(3125);
    CHECK(static_cast<int>(chip.read(reg::kX + reg::kVdVq) >> 16) == v_q);
  }
  CHECK(chip.read_signed(reg::kX + reg::kIqCmd) == 427);
  chip.codes[0] = {2048 + 100, 2048 - 50};  // i_alpha = 100, i_beta = 0: all of it d at angle 0
  chip.edges(3125);
  CHECK(chip.read(reg::kX + reg::kIdIq) == 100);
}

TEST_CASE("rules are read and written by index while the controller runs or rests") {
  KungBench chip;
  chip.write(reg::kX + reg::kTabAddr, 7 * 3 + 4);
  CHECK(chip.read_signed(reg::kX + reg::kTabData) == 2 << 20);
  chip.to_tick();
  chip.edge();
  chip.write(reg::kX + reg::kTabData, static_cast<std::uint32_t>(-12345));  // waits for its turn
  CHECK(chip.read_signed(reg::kX + reg::kTabData) == -12345);
  chip.write(reg::kX + reg::kTabAddr, 0);
  CHECK(chip.read_signed(reg::kX + reg::kTabData) == -(6 << 20));
  chip.write(reg::kX + reg::kCtrl, reg::kCtrlResetTable);
  CHECK((chip.read(reg::kX + reg::kStatus) & reg::kStatusBusy) != 0);
  chip.edges(60);
  CHECK((chip.read(reg::kX + reg::kStatus) & reg::kStatusBusy) == 0);
  chip.write(reg::kX + reg::kTabAddr, 7 * 3 + 4);
  CHECK(chip.read_signed(reg::kX + reg::kTabData) == 2 << 20);
}
