// SPDX-License-Identifier: Apache-2.0
//
// How fast a table may go along a segment and through the corner behind it, so that no axis exceeds
// its acceleration (docs/precision.md, "Feed profile").
#pragma once

#include <cstdint>

#include "sw_nios/path/feed_real.hpp"
#include "sw_nios/path/feed_segment.hpp"

namespace trammel::sw {

struct FeedLimits {
  std::uint64_t accel_x = 0, accel_y = 0;  // Q40 counts per point^2, above 0
  std::uint32_t mean = 8;                  // N, 1..64
};

struct FeedBounds {
  Real speed, accel;
};

// Along a segment. A is the smaller acceleration of the axes; a line may use that of its own axes.
FeedBounds feed_bounds(const FeedSegment& g, const FeedLimits& limits);

// Around the corner between two segments that have bounds of their own.
struct FeedCorner {
  FeedBounds bounds;
  bool stop = false;  // the table stops between them
};
FeedCorner feed_corner(const FeedSegment& p, const FeedBounds& of_p, const FeedSegment& q,
                       const FeedBounds& of_q, const FeedLimits& limits);

// The acceleration that is enough between the zones of two corners, from one speed over a length to
// another.
Real feed_swing(const Real& length, const Real& in, const Real& out, const FeedLimits& limits);

}  // namespace trammel::sw
