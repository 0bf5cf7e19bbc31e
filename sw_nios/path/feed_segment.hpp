// SPDX-License-Identifier: Apache-2.0
//
// What the feed profile knows of a path: lines and arcs with their feed and stops, and the phases
// of motion that the look-ahead finds for them. Lengths are counts, times are points, speeds counts
// per point.
#pragma once

#include <cstdint>

#include "sw_nios/path/q32.hpp"

namespace trammel::sw {

inline constexpr std::uint32_t kMaxSegments = 4096;
inline constexpr int kFeedBits = 40;  // fraction of speeds and accelerations
// An arc of a larger radius, 2^20 counts, is flat: it is drawn from where it begins, as 2^-32 turn
// at its centre are too coarse.
inline constexpr std::uint64_t kFlatRadius = std::uint64_t{1} << 52;  // Q32

// The reader of the moves knows lengths and directions better than 32 bits of them tell, so the
// sine of a corner and the length of an arc are given, not derived.
struct FeedSegment {
  Vec origin;                   // Q32: where a line or a flat arc begins; the centre of an arc
  Point end;                    // Q8
  std::uint64_t length = 0;     // Q32, above 0
  std::uint64_t feed = 0;       // Q40, above 0
  std::uint64_t half_sine = 0;  // Q62: of half the angle to the next segment
  std::uint64_t radius = 0;     // Q32; 0: a line
  std::uint64_t rate = 0;       // arc: 2^-64 turn per count, flat 2^-64 rad
  std::uint32_t angle = 0;      // arc: where it begins [2^-32 turn]
  std::int32_t dx = 0, dy = 0;  // line, flat arc: its direction, there where it begins, Q30
  std::uint32_t dwell = 0;      // points of rest at its end, if it stops there
  bool left = false;            // arc: counter-clockwise
  bool stop = false;            // a chain ends here; the look-ahead sets it where a corner needs it
  bool exact = false;           // a stop unless the corner is below 1 degree
};

// As a loader writes it, whatever the computer is.
static_assert(sizeof(FeedSegment) == 88, "the same layout on every computer");

// Motion with constant acceleration; the last one of a chain has neither speed nor acceleration.
struct FeedPhase {
  std::uint64_t begin = 0;  // since the chain began, Q32
  std::uint64_t path = 0;   // of the chain until then, Q32
  std::uint64_t speed = 0;  // Q40
  std::int64_t accel = 0;   // Q40

  constexpr bool rest() const { return speed == 0 && accel == 0; }
};

}  // namespace trammel::sw
