// SPDX-License-Identifier: Apache-2.0
//
// The move before the path from which the estimator learns mass and friction (docs/precision.md,
// "Identification move"): rest, three waves, rest, and again rest with the gains of the path.
#pragma once

#include <cstdint>

#include "sw_nios/apps/kung/rounding.hpp"
#include "sw_nios/path/sine1024.hpp"

namespace trammel::sw {

struct Identification {
  static constexpr std::uint32_t kFirst = 16;        // point of the first wave
  static constexpr std::uint32_t kEnd = 16 + 96;     // the last one is over
  static constexpr std::uint32_t kFull = kEnd + 6;   // full gains from here on
  static constexpr std::uint32_t kPoints = kFull + 26;

  // Of a point from the start, in the direction of the move; `wave` from end to end.
  static constexpr std::int32_t offset(std::uint32_t point, std::int32_t wave) {
    if (point < kFirst || point >= kEnd) return 0;
    const std::int32_t cosine = sine1024(static_cast<std::int32_t>(32 * (point - kFirst) + 256));
    return static_cast<std::int32_t>(rs(std::int64_t{wave} * (1024 - cosine), 11));
  }
};

}  // namespace trammel::sw
