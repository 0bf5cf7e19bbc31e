// SPDX-License-Identifier: Apache-2.0
//
// Random bus transfers of kung_xy that keep its drives running, tripping and starting again.
#pragma once

#include <cstdint>
#include <vector>

#include "cosim/cosim.hpp"
#include "rtl/chips/generated/kung_xy_regs.hpp"
#include "tests/support/random.hpp"

namespace trammel::test {

inline std::uint32_t below(Random& random, std::uint32_t n) { return random() % n; }

// A transfer as a program might make it: mostly the registers that matter while the drives run.
inline cosim::BusOp random_transfer(Random& random) {
  namespace reg = kung_xy_regs;
  const std::uint32_t base = below(random, 2) == 0 ? reg::kX : reg::kY;
  const std::uint32_t any = random();
  if (below(random, 5) < 2) {  // read anything, the empty places too
    const bool axis = below(random, 4) != 0;
    return {(axis ? base : 0x200u) + 4 * below(random, axis ? 0x32u : 0x12u), 0, false};
  }
  switch (below(random, 34)) {
    case 0:
    case 1:
    case 2: return {base + reg::kCtrl, below(random, 4) == 0 ? any : (any & 0xCFu) | 3u, true};
    case 3: return {base + reg::kCtrl, any & 0xFEu, true};
    case 4:
    case 5: return {reg::kCommit, any, true};
    case 6:
    case 7: return {base + reg::kPosCmd, any & 0x3FFFu, true};
    case 8: return {base + reg::kPosPreset, any & 0x3FFFu, true};
    case 9: return {reg::kIrqStat, any & 3u, true};
    case 10: return {reg::kIrqEn, any, true};
    case 11: return {base + reg::kStatus, any, true};
    case 12: return {reg::kFaultClear, reg::kKeyFaultClear, true};
    case 13: return {reg::kLock, below(random, 3) == 0 ? reg::kKeyLock : reg::kKeyUnlock, true};
    case 14: return {base + reg::kTabAddr, any, true};
    case 15: return {base + reg::kTabData, any, true};
    case 16: return {reg::kCurrentLimit, below(random, 4) == 0 ? any & 0x7FFu : 2000u, true};
    case 17: return {reg::kWatchdog, any & 7u, true};
    case 18: return {reg::kIrqPeriod, any & 3u, true};
    case 19: return {base + reg::kDeadtime, (any & 0xF00FFu) | (any >> 30 << 8), true};
    case 20: return {reg::kDeadtimeMin, any & 0x7Fu, true};
    case 21: return {base + reg::kStrokeEn, below(random, 4) == 0 ? 1u : 0u, true};
    case 22: return {base + reg::kStrokeMin + 4 * below(random, 2), any & 0x3FFFu, true};
    case 23: return {base + reg::kIqManual, any, true};
    case 24: return {base + reg::kAngleStep, any, true};
    case 25: return {base + reg::kCurrentOffset, any & 0x003F003Fu, true};
    case 26: return {base + reg::kAdcFrame, below(random, 4) == 0 ? any : 4u, true};
    case 27: return {reg::kRates, any, true};
    case 28: return {base + reg::kCtrl, (any & 0x1CFu) | 0x103u, true};
    case 29: return {base + reg::kPrecAddr, any & 15u, true};
    case 30:
    case 31:
    case 32: return {base + reg::kPrecData, below(random, 2) == 0 ? any : any & 0x1F07FFu, true};
    default: return {base + reg::kKp + 4 * below(random, 12), any, true};
  }
}

// What a program does to restart after a trip.
inline std::vector<cosim::BusOp> recovery(Random& random) {
  namespace reg = kung_xy_regs;
  const auto mode = [&random] { return (random() & 0x1CEu) | 1u; };
  return {{reg::kX + reg::kCtrl, 0, true},
          {reg::kY + reg::kCtrl, 0, true},
          {reg::kLock, reg::kKeyUnlock, true},
          {reg::kX + reg::kStatus, ~0u, true},
          {reg::kY + reg::kStatus, ~0u, true},
          {reg::kX + reg::kStrokeEn, 0, true},
          {reg::kY + reg::kStrokeEn, 0, true},
          {reg::kCurrentLimit, 0, true},
          {reg::kWatchdog, below(random, 2) * 40, true},
          {reg::kFaultClear, reg::kKeyFaultClear, true},
          {reg::kX + reg::kCtrl, mode(), true},
          {reg::kY + reg::kCtrl, mode(), true}};
}

}  // namespace trammel::test
