// SPDX-License-Identifier: Apache-2.0
//
// Whether a shaft came to rest where it was to go.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace trammel::lm628 {

// Largest distance from the target, and largest movement there [count]: `asked`, or for 0 a quarter
// of the travel, between 3 and 50.
inline double reached_band(int asked, double travel) {
  return asked != 0 ? asked : std::clamp(travel / 4, 3.0, 50.0);
}

struct Rest {
  double off = 0;    // [count] middle of where the shaft was, from the target
  double moves = 0;  // [count] from its lowest to its highest place
};

// Over samples `first` to `last`; at(k) is the true position [count] in one of them. The part
// counts modulo 2^32.
template <class At>
Rest rest_of(std::size_t first, std::size_t last, double target, At at) {
  const auto off = [&](std::size_t k) { return std::remainder(at(k) - target, 4294967296.0); };
  double low = off(last), high = low;
  for (std::size_t k = first; k < last; ++k) {
    low = std::min(low, off(k));
    high = std::max(high, off(k));
  }
  return {(low + high) / 2, high - low};
}

}  // namespace trammel::lm628
