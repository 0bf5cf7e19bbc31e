// SPDX-License-Identifier: Apache-2.0
//
// Sine and cosine of an angle, 1024 steps per revolution: round(2048 sin), clipped to 2047.
// Twin of rtl/drive/sine.sv.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "models/fixed/fixed.hpp"

namespace trammel::exact {

// The first quarter, crest included. Rotation by 2 pi / 1024 in Q30: the error stays below 1e-4 of
// a step, and the entry nearest to a rounding boundary is 9e-4 away. Integers, so that every
// compiler and C library gives this table.
constexpr std::array<std::int32_t, 257> sine_quarter() {
  constexpr std::int64_t kCos = 1073721611;  // round(2^30 cos(2 pi / 1024))
  constexpr std::int64_t kSin = 6588356;     // round(2^30 sin(2 pi / 1024))
  std::array<std::int32_t, 257> table{};
  std::int64_t c = std::int64_t{1} << 30;
  std::int64_t s = 0;
  for (std::size_t k = 0; k < table.size(); ++k) {
    table[k] = static_cast<std::int32_t>(fixed::rs(s, 19));
    const std::int64_t next = fixed::rs(c * kCos - s * kSin, 30);
    s = fixed::rs(s * kCos + c * kSin, 30);
    c = next;
  }
  return table;
}

class Sine {
 public:
  struct In {
    std::uint32_t angle = 0;  // 0..1023
  };
  struct Out {
    std::int32_t sin = 0, cos = 0;
  };

  void reset() {}

  Out step(const In& in) const { return {value(in.angle), value(in.angle + 256)}; }

  static constexpr std::int32_t value(std::uint32_t angle) {
    const std::uint32_t in_quarter = angle & 255;
    const std::uint32_t k = (angle & 256) != 0 ? 256 - in_quarter : in_quarter;
    const std::int32_t magnitude = kQuarter[k];
    if ((angle & 512) != 0) return -magnitude;
    return magnitude > 2047 ? 2047 : magnitude;
  }

 private:
  static constexpr std::array<std::int32_t, 257> kQuarter = sine_quarter();
};

}  // namespace trammel::exact
