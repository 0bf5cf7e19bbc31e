// SPDX-License-Identifier: Apache-2.0
//
// A hash over all events of a run with their edges: equal for every wiring, window and leap.
#pragma once

#include <cstdint>

#include "cosim/cosim.hpp"

namespace trammel::cosim {

class EventHash {
 public:
  std::uint64_t value() const { return hash_; }
  Clk events() const { return events_; }  // clocks at which the loop saw something

  // One round of a 64-bit multiply-xorshift: cheap, and every event moves all later values.
  void mix(std::uint64_t value) {
    hash_ = (hash_ ^ value) * 0x9e3779b97f4a7c15u;
    hash_ ^= hash_ >> 29;
  }

  void mix(const Stop& stop, const Chip& chip) {
    ++events_;
    mix(static_cast<std::uint64_t>(stop.edge));
    mix((std::uint64_t{stop.why} << 32) | chip.drive());
    if ((stop.why & kBusDone) != 0) mix(chip.rdata());
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
  Clk events_ = 0;
};

}  // namespace trammel::cosim
