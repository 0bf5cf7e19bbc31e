// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace trammel::plant {

// The first clock after `low` at which `holds(clock)`: it does so from there to `high`, and not at
// `low`.
template <class Holds>
std::int64_t first_clock(std::int64_t low, std::int64_t high, const Holds& holds) {
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (holds(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace trammel::plant
