// SPDX-License-Identifier: Apache-2.0
//
// kung_xy beside its twin where one write or one value of a register decides at which clock the
// gates switch.
#include <Vkung_xy.h>

#include <catch2/catch.hpp>

#include <cstdint>

#include "tests/chips/kung_pair.hpp"

using namespace trammel;
namespace reg = trammel::kung_xy_regs;

namespace {

constexpr std::int64_t kPeriod = 3125;  // [clk] of 16 kHz

struct Pair : test::KungPair<Vkung_xy> {
  Pair() {
    rtl().reset();
    begin();
    clocks(200);  // encoder lines adopted, rule tables filled
  }
  // So many clocks after a 16 kHz tick.
  void to_phase(std::int64_t phase) { clocks((phase - now() % kPeriod + kPeriod) % kPeriod); }
};

}  // namespace

TEST_CASE("a limit lowered while the converters run trips as soon as their currents are taken") {
  for (const std::int64_t phase : {5, 30, 50, 60}) {
    for (const std::uint32_t base : {reg::kX, reg::kY}) {
      CAPTURE(phase, base);
      Pair pair;
      pair.write(base + reg::kCtrl, reg::kCtrlEnable);
      pair.to_phase(2000);
      pair.codes[base == reg::kX ? 0 : 1][0] += 300;
      pair.to_phase(phase);
      REQUIRE(pair.gates_on() > 0);
      pair.write(reg::kCurrentLimit, 300);
      pair.to_phase(75);  // taken at 65, seen at 66, latched at 67, gates off at 68
      CHECK(pair->gate_hi_o + pair->gate_lo_o == 0);
      CHECK((pair.read(reg::kFault) & reg::kFaultCodeMask) == reg::kFaultCodeOverCurrent);
    }
  }
}

TEST_CASE("a dead time of 0 acts as 1, and one of 2 as 2, at each switch of a leg") {
  for (const std::uint32_t dead_time : {0u, 1u, 2u}) {
    CAPTURE(dead_time);
    Pair pair;
    pair.write(reg::kDeadtimeMin, 0);
    pair.write(reg::kX + reg::kDeadtime, dead_time);
    pair.write(reg::kX + reg::kCtrl, reg::kCtrlEnable);
    pair.to_phase(2000);
    int off = 0;  // clocks with both gates of leg a off
    for (int n = 0; n < kPeriod; ++n) {
      pair.clocks(1);
      off += ((pair->gate_hi_o | pair->gate_lo_o) & 1) == 0;
    }
    CHECK(off == 2 * (dead_time == 0 ? 1 : static_cast<int>(dead_time)));
    pair.clocks(3 * kPeriod);  // and leaping
  }
}

// Rules are tuned at clocks 64, 66, 68 and 70 of a sample; a reset of the table that waits for the
// end of the sample already ends that.
TEST_CASE("a rule is tuned no more once the reset of its table is asked for") {
  int tuned = 0, initial = 0;
  for (const std::uint32_t base : {reg::kX, reg::kY}) {
    for (std::int64_t begin = 50; begin < 72; ++begin) {
      CAPTURE(base, begin);
      Pair pair;
      pair.write(base + reg::kCtrl, reg::kCtrlAdapt);
      pair.write(base + reg::kEta, 0x1C0000 | 2047);
      pair.write(base + reg::kShift, 0);
      pair.write(base + reg::kPosPreset, 1280);  // e and de: half way between their first knots
      pair.write(base + reg::kTabAddr, 8);       // the last of four rules, at clock 70
      const std::uint32_t before = pair.read(base + reg::kTabData);
      pair.clocks((begin - pair.now() % (8 * kPeriod) + 8 * kPeriod) % (8 * kPeriod));
      pair.write(base + reg::kCtrl, reg::kCtrlAdapt | reg::kCtrlResetTable);
      while (pair.now() % (8 * kPeriod) < 90) {  // past the reset itself
        // Of the RTL; the twin's is compared.
        (pair.read(base + reg::kTabData) != before ? tuned : initial) += 1;
      }
    }
  }
  CHECK(tuned > 0);
  CHECK(initial > 0);
}
