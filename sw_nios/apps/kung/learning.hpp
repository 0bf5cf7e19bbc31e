// SPDX-License-Identifier: Apache-2.0
//
// Corrections of one axis that grow from lap to lap by the errors of the lap before
// (docs/precision.md, "Learning"). They belong to the caller: 16 bits a point [2^-8 count].
#pragma once

#include <array>
#include <cstdint>

#include "sw_nios/apps/kung/precision_setup.hpp"

namespace trammel::sw {

class Learning {
 public:
  static constexpr std::uint32_t kEnds = 12;        // points at both ends of a lap without any
  static constexpr std::int32_t kSlow = 2 * 256;    // way from point to point without any

  Learning() = default;
  // `lap`: points from one lap to the next; a lap of more than Corrections::kPoints has none.
  Learning(std::array<std::int16_t, Corrections::kPoints>* corrections, std::uint32_t lap,
           std::uint32_t gain);

  // To be added to that point of the path, which step() has not passed by more than 5.
  std::int32_t correction(std::uint32_t point) const;

  // When `point` of the path is written: its way from the one before and ERR_SUM of the last knot.
  void step(std::uint32_t point, std::int32_t way, std::int32_t err_sum);

 private:
  std::array<std::int16_t, Corrections::kPoints>* corrections_ = nullptr;
  std::uint32_t lap_ = 0;
  std::uint32_t gain_ = 0;
  std::int32_t err_sum_ = 0;           // of the knot before the last
  std::array<std::int32_t, 5> wrong_{};  // what the last points were off, the newest first
  std::uint32_t moved_ = 0;            // bit k: k points ago the axis moved
};

}  // namespace trammel::sw
