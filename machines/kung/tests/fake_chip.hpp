// SPDX-License-Identifier: Apache-2.0
//
// The trajectory program on registers that are plain memory, with the reactions it relies on.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "rtl/chips/generated/kung_xy_regs.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::test {

namespace reg = kung_xy_regs;

struct Access {
  std::uint32_t address, data;
  bool write;
};

// Registers as plain memory with the few reactions the program relies on.
class FakeChip final : public sw::Bus {
 public:
  std::map<std::uint32_t, std::uint32_t> registers{{reg::kId, reg::kIdValue}};
  std::vector<Access> log;
  std::uint32_t busy_polls = 3;  // STATUS reads a table reset stays busy for
  std::array<std::uint32_t, 2> shown_status{};  // STATUS of X and Y, but for busy of a reset
  std::array<std::uint32_t, 2> lost_stops{};    // writes of 0 to CTRL of X and Y that do nothing
  bool presets = true;
  bool fault_stays = false;
  std::uint32_t ticks_per_commit = 0;
  int tick_at_read = 0;  // reads of TICK in an interrupt after which it is one further; 0 = none

  std::uint32_t read(std::uint32_t address) override {
    std::uint32_t data = registers[address];
    if (address == reg::kTick) {
      data += tick_at_read != 0 && reads_of_tick_ >= tick_at_read ? 1 : 0;
      ++reads_of_tick_;
    }
    if (address == reg::kX + reg::kStatus || address == reg::kY + reg::kStatus) {
      std::uint32_t& left = busy_[address >= reg::kY];
      data = shown_status[address >= reg::kY] | (left > 0 ? reg::kStatusBusy : 0);
      left -= left > 0 ? 1 : 0;
    }
    log.push_back({address, data, false});
    return data;
  }

  void write(std::uint32_t address, std::uint32_t data) override {
    log.push_back({address, data, true});
    for (const std::uint32_t base : {reg::kX, reg::kY}) {
      if (address == base + reg::kCtrl && data == 0 && lost_stops[base == reg::kY] > 0) {
        --lost_stops[base == reg::kY];
        return;
      }
      if (address == base + reg::kPosPreset && presets) registers[base + reg::kPos] = data;
      if (address == base + reg::kCtrl && (data & reg::kCtrlResetTable) != 0) {
        busy_[base == reg::kY] = busy_polls;
        data &= ~reg::kCtrlResetTable;
      }
    }
    if (address == reg::kFaultClear && data == reg::kKeyFaultClear && !fault_stays) {
      registers[reg::kFault] = 0;
    }
    if (address == reg::kCommit) registers[reg::kTick] += ticks_per_commit;
    if (address == reg::kIrqStat) data = registers[address] & ~data;
    registers[address] = data;
  }

  void tick(std::uint32_t ticks) {
    registers[reg::kTick] += ticks;
    reads_of_tick_ = 0;
    registers[reg::kIrqStat] |= reg::kIrqStatTick;
  }

  std::vector<Access> writes(std::size_t from = 0) const {
    std::vector<Access> list;
    std::copy_if(log.begin() + static_cast<std::ptrdiff_t>(from), log.end(),
                 std::back_inserter(list), [](const Access& a) { return a.write; });
    return list;
  }

  // Index in the log of the n-th write to that address, or the length of the log.
  std::size_t write_index(std::uint32_t address, int n = 0) const {
    for (std::size_t i = 0; i < log.size(); ++i) {
      if (log[i].write && log[i].address == address && n-- == 0) return i;
    }
    return log.size();
  }

 private:
  std::uint32_t busy_[2] = {0, 0};
  int reads_of_tick_ = 0;
};

struct Machine {
  FakeChip chip;
  sw::KungApp app;
  std::uint32_t period;

  explicit Machine(const sw::KungSetup& setup = {}) : app(setup), period(setup.irq_period) {
    if (setup.precision.on) chip.tick_at_read = 3;  // it waits for that once
  }
  void interrupt() {
    chip.tick(period);
    app.isr(chip);
  }
  void arm() {
    app.start(chip);
    interrupt();
  }
};

inline sw::Failure failure(const Machine& m) {
  return static_cast<sw::Failure>(m.app.mailbox().failure);
}

// Words that an axis was written from an access on, by PREC_ADDR and what follows it.
inline std::vector<std::pair<std::uint32_t, std::uint32_t>> window(const FakeChip& chip,
                                                                   std::uint32_t base,
                                                                   std::size_t from) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> words;
  std::uint32_t at = 0;
  for (const Access& w : chip.writes(from)) {
    if (w.address == base + reg::kPrecAddr) at = w.data;
    if (w.address == base + reg::kPrecData) words.emplace_back(at++, w.data);
  }
  return words;
}

// The registers that keep a drive or an interrupt on, or "".
inline std::string still_on(FakeChip& chip) {
  std::string on;
  const std::pair<const char*, std::uint32_t> all[] = {
      {"x.CTRL", reg::kX + reg::kCtrl}, {"y.CTRL", reg::kY + reg::kCtrl}, {"IRQ_EN", reg::kIrqEn}};
  for (const auto& [name, address] : all) {
    const std::uint32_t value = chip.registers[address];
    if (value == 0) continue;
    on += (on.empty() ? "" : ", ") + std::string(name) + " = " + std::to_string(value);
  }
  return on;
}

}  // namespace trammel::test
