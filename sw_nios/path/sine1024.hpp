// SPDX-License-Identifier: Apache-2.0
//
// s(k) = round(1024 sin(2 pi k / 1024)) from a table of a quarter, computed when it is compiled.
#pragma once

#include <array>
#include <cstdint>

#include "sw_nios/path/q32.hpp"

namespace trammel::sw {
namespace detail {

constexpr std::array<std::int16_t, 257> quarter_sine() {
  std::array<std::int16_t, 257> table{};
  const Rotation step = Rotation::per_turn(1024);
  Vec at{Q32{1} << 60, 0};
  for (std::int16_t& value : table) {
    value = static_cast<std::int16_t>(((at.y >> 49) + 1) >> 1);
    at = step(at);
  }
  return table;
}

inline constexpr std::array<std::int16_t, 257> kQuarterSine = quarter_sine();

}  // namespace detail

constexpr std::int32_t sine1024(std::int32_t k) {
  const auto turn = static_cast<std::uint32_t>(k) & 1023u;
  const std::uint32_t in_half = turn & 511u;
  const std::int32_t value =
      detail::kQuarterSine[in_half <= 256 ? in_half : 512 - in_half];
  return turn < 512 ? value : -value;
}

}  // namespace trammel::sw
