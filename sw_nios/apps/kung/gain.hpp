// SPDX-License-Identifier: Apache-2.0
//
// A gain of the chip: value = mant / 2048 * 2^exp; mant 0..2047, exp -16..15.
#pragma once

#include <cstdint>

namespace trammel::sw {

struct Gain {
  std::int32_t mant = 0;
  std::int32_t exp = 0;
};

constexpr bool operator==(Gain a, Gain b) { return a.mant == b.mant && a.exp == b.exp; }

// As the registers of gains take it.
constexpr std::uint32_t gain_word(Gain gain) {
  return (static_cast<std::uint32_t>(gain.mant) & 0x7FFu) |
         (static_cast<std::uint32_t>(gain.exp) & 0x1Fu) << 16;
}

}  // namespace trammel::sw
