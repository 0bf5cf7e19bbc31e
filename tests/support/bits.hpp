// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace trammel::test {

// The low `bits` of a port as a two's complement number.
inline std::int64_t as_signed(std::uint64_t value, int bits) {
  const int shift = 64 - bits;
  return static_cast<std::int64_t>(value << shift) >> shift;
}

// The low `bits` of a number, to be written to a port.
inline std::uint32_t as_bits(std::int64_t value, int bits) {
  const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) & mask);
}

// One bit of a port.
inline void set_bit(std::uint8_t& port, std::size_t bit, bool high) {
  const unsigned others = port & ~(1u << bit);
  port = static_cast<std::uint8_t>(others | (high ? 1u : 0u) << bit);
}

}  // namespace trammel::test
