// SPDX-License-Identifier: Apache-2.0
//
// The words of a verilated LM628 for the record: what its engine's memory m_q and register u_q and
// its status byte say.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "parts/lm628/chip.hpp"

namespace trammel::lm628 {

// Clock domains in the order of lm628_pkg::domains_t, the lowest bit first.
inline constexpr std::array<const char*, 3> kDomains{"system", "engine", "sense"};

template <class Memory>
Words words_of(const Memory& memory, unsigned output, unsigned status) {
  // In the order of rtl/motion/lm628_engine.asm.
  enum Register { kPos = 0, kSpeed = 1, kActual = 5, kKp = 13, kKi = 14, kIl = 16, kSum = 23,
                  kDeriv = 25 };
  const auto m = [&memory](int n) {
    return static_cast<std::int64_t>(memory[static_cast<std::size_t>(n)]);
  };
  Words w;
  w.position = m(kPos);
  w.speed = static_cast<std::int32_t>(m(kSpeed));
  w.actual = static_cast<std::int32_t>(m(kActual));
  derive_error(w, m(kKp));
  w.integral = static_cast<std::int32_t>(
      std::clamp<std::int64_t>(m(kKi) * (m(kSum) >> 8), -m(kIl), m(kIl)));
  w.derivative = static_cast<std::int32_t>(m(kDeriv));
  w.output = static_cast<std::int16_t>(output);
  w.status = static_cast<std::uint8_t>(status);
  return w;
}

}  // namespace trammel::lm628
