// SPDX-License-Identifier: Apache-2.0
//
// What a record says of the plant, held against itself.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>

namespace trammel::test {

struct Motion {
  double place, speed;
};

// The speeds of a smooth motion are the slope of its places: `at(k)` is the Motion of sample k,
// `seconds` after the one before. 2 % of the largest speed are for its change within a sample.
template <class At>
void require_slope(const char* what, std::size_t samples, double seconds, At at) {
  double fastest = 0;
  for (std::size_t k = 0; k < samples; ++k) fastest = std::max(fastest, std::abs(at(k).speed));
  REQUIRE(fastest > 0);
  for (std::size_t k = 1; k < samples; ++k) {
    const Motion before = at(k - 1), now = at(k);
    const double slope = (now.place - before.place) / seconds;
    INFO(what << ", sample " << k << ": speed " << before.speed << " to " << now.speed
              << ", slope of the place " << slope);
    REQUIRE(std::abs(slope - (before.speed + now.speed) / 2) < 0.02 * fastest);
  }
}

}  // namespace trammel::test
