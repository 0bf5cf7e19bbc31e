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

namespace feed {

inline constexpr Real kShare = Real(7) / Real(10);   // of A along an arc, across it and in a corner
inline constexpr Real kSeen = Real(3) / Real(2);     // points that see a corner's turn
inline constexpr Real kFull = Real(14) / Real(15);   // of A: largest turn, 2 kShare/kSeen
inline constexpr Real kHalf = Real(35) / Real(100);  // of A: along the path where one takes kFull
inline constexpr Real kStraight = Real(5) / Real(1000);  // of A: a turn that leaves all of it
inline constexpr Real kSharp = kShare + Real(1) / Real(1000000000);
inline constexpr std::uint32_t kSlow = 1024;  // of the segments' speed: a corner that is a stop
inline constexpr std::uint64_t kHalfDegree = 40244041747161352;  // Q62: sine of it

constexpr Real least(const FeedLimits& l) {
  return Real(l.accel_x < l.accel_y ? l.accel_x : l.accel_y, kFeedBits);
}

}  // namespace feed

// Along a segment. A is the smaller acceleration of the axes; a line may use that of its own axes.
constexpr FeedBounds feed_bounds(const FeedSegment& g, const FeedLimits& l) {
  FeedBounds b{Real(g.feed, kFeedBits), {}};
  if (g.radius != 0) {
    b.accel = feed::kShare * feed::least(l);
    b.speed = min(b.speed, sqrt(b.accel * Real(g.radius, 32)));
    return b;
  }
  const Real x(magnitude(g.dx), 30), y(magnitude(g.dy), 30);
  const Real ax(l.accel_x, kFeedBits), ay(l.accel_y, kFeedBits);
  b.accel = x.zero() ? ay / y : y.zero() ? ax / x : min(ax / x, ay / y);
  return b;
}

// Around the corner between two segments.
constexpr FeedBounds feed_corner(const FeedSegment& p, const FeedSegment& q,
                                 const FeedLimits& limits) {
  const FeedBounds before = feed_bounds(p, limits), behind = feed_bounds(q, limits);
  FeedBounds c{min(before.speed, behind.speed), min(before.accel, behind.accel)};
  const Real A = feed::least(limits), one(1), two(2);
  const Real sine = min(Real(p.half_sine, 62), one);
  if (sine.zero()) return c;
  const Real tiny = Real(1) / Real(1000000000000000000u);
  const Real tangent = sine / sqrt(max(one - sine * sine, tiny));
  const Real shorter = Real(p.length < q.length ? p.length : q.length, 32);
  Real bend;  // mean curvature of both
  if (p.radius != 0) bend = one / (two * Real(p.radius, 32));
  if (q.radius != 0) bend = bend + one / (two * Real(q.radius, 32));

  c.speed = min(c.speed, feed::kShare * A / (feed::kSeen * sine));
  if (bend.zero()) c.speed = min(c.speed, sqrt(feed::kShare * A * shorter / (two * tangent)));
  // Shares of A that the turn takes, of one corner and of many within a point, and the arcs.
  const auto turn = [&] {
    return max(two * sine * c.speed / A, two * tangent * c.speed * c.speed / (shorter * A));
  };
  const auto load = [&] { return turn() + bend * c.speed * c.speed / A; };
  if (!(turn() > feed::kStraight)) return c;
  if (!bend.zero() && load() > feed::kFull) c.speed = c.speed * feed::kFull / load();
  if (turn() > feed::kStraight) {
    c.accel = min(c.accel, (load() > feed::kSharp ? feed::kHalf : feed::kShare) * A);
  }
  return c;
}

// Whether the table stops between them.
constexpr bool feed_stops(const FeedSegment& p, const FeedSegment& q, const FeedLimits& limits) {
  if (p.exact && p.half_sine > feed::kHalfDegree) return true;
  const Real both = min(feed_bounds(p, limits).speed, feed_bounds(q, limits).speed);
  return feed_corner(p, q, limits).speed * Real(feed::kSlow) < both;
}

}  // namespace trammel::sw
