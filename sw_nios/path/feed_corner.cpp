// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/path/feed_corner.hpp"

#include "sw_nios/path/q32.hpp"

namespace trammel::sw {
namespace {

constexpr Real kShare = Real::ratio(7, 10);       // of A along an arc, across it, near a corner
constexpr Real kSeen = Real::ratio(3, 2);         // points that see a corner's turn
constexpr Real kFull = Real::ratio(14, 15);       // of A: turn and arcs, 2 kShare/kSeen
constexpr Real kHalf = Real::ratio(35, 100);      // of A: along the path where a corner takes kFull
// Of A: half the change of speed in a corner. An axis could bear kShare. But where its current has
// just changed its sign, the current loop first crosses its dead time: the force is 1 ms late, and
// a light table, which swings there already, is further off by that times the change of speed.
constexpr Real kTurn = Real::ratio(1, 2);
// Points in which the speed rises, and again falls, between two corners, unless kHalf of A is
// enough for less. Harder pushes would turn the force of a light table round, through the dead
// time, at each chord of a curve.
constexpr std::uint64_t kSwing = 12;
constexpr Real kStraight = Real::ratio(5, 1000);  // of A: a turn that leaves all of it
constexpr Real kSharp = Real::ratio(700000001, 1000000000);  // kShare, and what rounding adds
constexpr std::uint32_t kSlow = 1024;  // of the segments' speed: a corner that is a stop
constexpr std::uint64_t kHalfDegree = 40244041747161352;  // Q62: its sine
// A turn back, within 0.005 deg.
constexpr std::uint64_t kBack = (std::uint64_t{1} << 62) - (std::uint64_t{1} << 32);

Real least(const FeedLimits& l) {
  return Real(l.accel_x < l.accel_y ? l.accel_x : l.accel_y, kFeedBits);
}

}  // namespace

FeedBounds feed_bounds(const FeedSegment& g, const FeedLimits& l) {
  FeedBounds b{Real(g.feed, kFeedBits), {}};
  if (g.radius != 0) {
    b.accel = kShare * least(l);
    b.speed = min(b.speed, sqrt(b.accel * Real(g.radius, 32)));
    return b;
  }
  const Real x(magnitude(g.dx), 30), y(magnitude(g.dy), 30);
  const Real ax(l.accel_x, kFeedBits), ay(l.accel_y, kFeedBits);
  b.accel = x.zero() ? ay / y : y.zero() ? ax / x : min(ax / x, ay / y);
  return b;
}

FeedCorner feed_corner(const FeedSegment& p, const FeedBounds& of_p, const FeedSegment& q,
                       const FeedBounds& of_q, const FeedLimits& limits) {
  const Real speed = min(of_p.speed, of_q.speed);
  FeedBounds c{speed, min(of_p.accel, of_q.accel)};
  if (p.half_sine > (p.exact ? kHalfDegree : kBack)) return {c, true};
  const Real A = least(limits), one(1), two(2);
  const Real sine = min(Real(p.half_sine, 62), one);
  if (sine.zero()) return {c, false};
  const Real tangent = sine / sqrt(one - sine * sine);
  const Real shorter = Real(p.length < q.length ? p.length : q.length, 32);
  Real bend;  // mean curvature of both
  if (p.radius != 0) bend = one / (two * Real(p.radius, 32));
  if (q.radius != 0) bend = bend + one / (two * Real(q.radius, 32));

  c.speed = min(c.speed, kTurn * A / (kSeen * sine));
  if (bend.zero()) c.speed = min(c.speed, sqrt(kShare * A * shorter / (two * tangent)));
  // Share of A that the turn takes: of one corner, or of many within a point.
  const Real one_corner = two * sine / A, many = two * tangent / (shorter * A);
  const auto turn = [&] { return max(one_corner * c.speed, many * c.speed * c.speed); };
  Real share = turn();
  if (share > kStraight) {
    Real load = share + bend * c.speed * c.speed / A;
    if (!bend.zero() && load > kFull) {
      c.speed = c.speed * kFull / load;
      share = turn();
      load = share + bend * c.speed * c.speed / A;
    }
    if (share > kStraight) c.accel = min(c.accel, (load > kSharp ? kHalf : kShare) * A);
  }
  return {c, c.speed * Real(kSlow) < speed};
}

Real feed_swing(const Real& length, const Real& in, const Real& out, const FeedLimits& limits) {
  const Real swing(kSwing), low = min(in, out), high = max(in, out);
  const Real needed = (high * high - low * low) / (Real(2) * length);
  const Real slow = (length - (in + out) * swing) / (swing * swing);
  return max(max(kHalf * least(limits), slow), needed);
}

}  // namespace trammel::sw
