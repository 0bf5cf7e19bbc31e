// SPDX-License-Identifier: Apache-2.0
//
// What a master of an AXI4-Lite port says of a transfer that the chip does not answer as it must.
#pragma once

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace trammel::test {

// "write of 0x078: no response on B, 901 evaluated clocks after it was begun"
[[noreturn]] inline void fail_transfer(bool write, std::uint32_t address, const std::string& what,
                                       int clocks) {
  char place[32];
  std::snprintf(place, sizeof place, "%s of 0x%03X: ", write ? "write" : "read", address);
  throw std::runtime_error(place + what + ", " + std::to_string(clocks) +
                           " evaluated clocks after it was begun");
}

// The channel on which a transfer waits; taken: its address and its word were accepted.
inline const char* waits_on(bool write, bool address_taken, bool word_taken) {
  if (!address_taken) {
    return write ? "its address is not taken on AW" : "its address is not taken on AR";
  }
  if (write && !word_taken) return "its word is not taken on W";
  return write ? "no response on B" : "no response on R";
}

}  // namespace trammel::test
