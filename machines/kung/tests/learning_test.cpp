// SPDX-License-Identifier: Apache-2.0
//
// Which points of a lap get a correction: all but those at its ends, where an axis moves.
#include "sw_nios/apps/kung/learning.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>

using namespace trammel::sw;

namespace {

constexpr std::uint32_t kLap = 60, kGain = 1u << 14;
constexpr std::int32_t kErrSum = 32 * 100;

using Table = std::array<std::int16_t, Corrections::kPoints>;

// After three laps in which the axis goes this way from point to point and is off by as much.
Table learned(std::int32_t way) {
  Table table{};
  table.fill(77);  // of a run before
  Learning learning(&table, kLap, kGain);
  for (std::uint32_t point = 0; point < 3 * kLap; ++point) learning.step(point, way, kErrSum);
  return table;
}

}  // namespace

TEST_CASE("a lap has corrections from its 13th point to the 13th from its end, no other") {
  for (const std::int32_t way : {Learning::kSlow, -Learning::kSlow}) {
    const Table table = learned(way);
    for (std::uint32_t at = 0; at < table.size(); ++at) {
      INFO("point " << at << ", way " << way);
      CHECK((table[at] != 0) == (at >= Learning::kEnds && at < kLap - Learning::kEnds));
    }
  }
}

TEST_CASE("an axis that is slow gets none") {
  for (const std::int32_t way : {Learning::kSlow - 1, 1 - Learning::kSlow, 0}) {
    CHECK(learned(way) == Table{});
  }
}
