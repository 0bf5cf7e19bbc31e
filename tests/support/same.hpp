// SPDX-License-Identifier: Apache-2.0
//
// Comparisons of an RTL with its twin, made at every clock, that say what differs: pin or register,
// both values, and when.
#pragma once

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace trammel::test {

// "131 (0x83)", as a number and as its bits; small numbers look the same as either.
inline std::string number(std::int64_t value, int digits = 2) {
  char text[48];
  const auto bits = static_cast<unsigned long long>(value);
  std::snprintf(text, sizeof text, value >= 0 && value < 10 ? "%lld" : "%lld (0x%0*llX)",
                static_cast<long long>(value), digits, value < 0 ? bits & 0xFFFFFFFF : bits);
  return text;
}

inline std::string after_clock(std::int64_t clock) {
  return ", after clock " + std::to_string(clock);
}

// Throws if the pin or word `what` of the RTL is not that of its twin.
template <class Rtl, class Twin>
void same(const char* what, const Rtl& rtl, const Twin& twin, std::int64_t clock) {
  const auto ours = static_cast<std::int64_t>(rtl), theirs = static_cast<std::int64_t>(twin);
  if (ours == theirs) return;
  throw std::logic_error(what + (" of the RTL is " + number(ours)) + ", of its twin " +
                         number(theirs) + after_clock(clock));
}

// "STATUS (0x00C)"; a chip's list of registers is kRegisters of its generated header. A register of
// no name is one that the map does not have.
template <class Registers>
std::string register_name(const Registers& registers, std::uint32_t address) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%03X", address);
  for (const auto& one : registers) {
    if (one.address == (address & ~3u)) return one.name + (" (" + std::string(text) + ")");
  }
  return text;
}

}  // namespace trammel::test
