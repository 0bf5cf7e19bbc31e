// SPDX-License-Identifier: Apache-2.0
//
// A port of a chip in the packed words that chip and plant exchange. The table of a chip's ports
// has the names of its RTL; verilated model, twin, plant and faults all use it.
#pragma once

#include <cstdint>

namespace trammel {

// Bits of a port and the lines that they are: groups of `width` neighbours, `step` lines apart.
struct Port {
  int first = 0;  // line of bit 0
  int width = 1;
  int groups = 1;
  int step = 0;
  bool low = false;  // a bit is low where its line is high

  constexpr int operator()(int bit) const { return first + bit / width * step + bit % width; }

  // The port's value at these lines.
  constexpr unsigned value(std::uint64_t lines) const {
    unsigned found = 0;
    for (int group = 0; group < groups; ++group) {
      const auto bits = static_cast<unsigned>(lines >> (first + group * step)) & ones(width);
      found |= bits << group * width;
    }
    return low ? ~found & ones(width * groups) : found;
  }

  // The lines at this value.
  constexpr std::uint64_t lines(unsigned value) const {
    if (low) value = ~value;
    std::uint64_t found = 0;
    for (int group = 0; group < groups; ++group) {
      found |= std::uint64_t{value >> group * width & ones(width)} << (first + group * step);
    }
    return found;
  }

  template <class Member>
  constexpr void put(Member& port, std::uint64_t lines) const {
    port = static_cast<Member>(value(lines));
  }

 private:
  static constexpr unsigned ones(int bits) { return (1u << bits) - 1; }
};

constexpr bool level(std::uint64_t lines, int line) { return (lines >> line & 1) != 0; }

// A port of two bits, bit 0 first.
constexpr std::uint8_t both(bool first, bool second) {
  return static_cast<std::uint8_t>(first | second << 1);
}

}  // namespace trammel
