// SPDX-License-Identifier: Apache-2.0
//
// Stored registers of kung_xy, and those of an axis as its blocks see them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "models/exact/chips/kung_current.hpp"
#include "models/fixed/fixed.hpp"
#include "rtl/chips/generated/kung_xy_regs.hpp"

namespace trammel::exact {

class KungRegisters {
 public:
  KungRegisters() {
    for (const kung_xy_regs::Register& reg : kung_xy_regs::kRegisters) {
      words_[reg.address / 4] = reg.reset;
    }
  }

  // 0 where nothing is stored.
  std::uint32_t word(std::uint32_t address) const {
    return address / 4 < words_.size() ? words_[address / 4] : 0;
  }

  // Writes these of the bits. Returns those that pulse.
  std::uint32_t write(std::uint32_t address, std::uint32_t data, std::uint32_t written,
                      bool locked) {
    const auto* const reg = std::lower_bound(
        kung_xy_regs::kRegisters.begin(), kung_xy_regs::kRegisters.end(), address,
        [](const kung_xy_regs::Register& r, std::uint32_t a) { return r.address < a; });
    if (reg == kung_xy_regs::kRegisters.end() || reg->address != address) return 0;
    const std::uint32_t bits = reg->written & written & ~(locked ? reg->locked : 0);
    std::uint32_t& word = words_[address / 4];
    word = (word & ~bits) | (data & bits);
    return data & written & reg->pulsed;
  }

  // The chip itself writes it.
  void set(std::uint32_t address, std::uint32_t word) { words_[address / 4] = word; }

 private:
  std::array<std::uint32_t, kung_xy_regs::kRegisters.back().address / 4 + 1> words_{};
};

struct KungAxisRegisters {
  bool enable = false, current_loop = false, position_loop = false;
  bool stroke_enable = false;
  std::int32_t stroke_min = 0, stroke_max = 0;  // [counts]
  std::int32_t pos_cmd = 0;                     // [counts]
  std::int32_t iq_manual = 0;                   // I_fs / 4096
  std::uint32_t dead_time = 0;                  // [clk], the one in effect
  bool interpolate = false;
  bool precision = false;
  int qep_filter = 3;                           // [clk]
  KungCurrent::Config current;
};

// The low `bits` bits as a two's complement number.
constexpr std::int32_t signed_word(std::uint32_t word, int bits) {
  return static_cast<std::int32_t>(fixed::wrap(static_cast<std::int64_t>(word), bits));
}

constexpr fixed::Gain gain_of(std::uint32_t word) {
  using namespace kung_xy_regs;
  return {static_cast<std::int32_t>((word & kKpMantMask) >> kKpMantShift),
          signed_word((word & kKpExpMask) >> kKpExpShift, 5)};
}

}  // namespace trammel::exact
