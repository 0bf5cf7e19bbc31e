// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/plan/feed_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/kung/plan/parts.hpp"

namespace trammel::kung {
namespace {

constexpr double kMaxRadius = 2147483648;     // counts
constexpr double kMaxFlat = 0.25;             // rad, of an arc whose radius is above 2^20 counts
constexpr double kLeastLength = 1.0 / 8192;   // counts
constexpr double kReach = 1 << 20;            // counts: largest place and length of a line
constexpr double kMostSpeed = 32768;          // counts per point
constexpr double kMostAccel = 1 << 22;        // counts per point^2
constexpr double kMostWindow = 65536;         // counts that the mean may span

std::uint64_t fixed(double value, int bits) {
  return static_cast<std::uint64_t>(std::llround(std::ldexp(value, bits)));
}

std::int32_t q8(double counts) { return static_cast<std::int32_t>(std::floor(256 * counts + 0.5)); }

// Unit vector along a move at one of its ends.
ideal::Place tangent(const ideal::Move& m, bool at_end) {
  if (m.kind == ideal::Move::Kind::kLine) {
    const double length = m.length();
    return {(m.to.x - m.from.x) / length, (m.to.y - m.from.y) / length};
  }
  const double angle =
      std::atan2(m.from.y - m.center.y, m.from.x - m.center.x) + (at_end ? m.sweep : 0);
  const double sign = m.sweep > 0 ? 1 : -1;
  return {-sign * std::sin(angle), sign * std::cos(angle)};
}

void direct(sw::FeedSegment& g, const ideal::Place& unit) {
  g.dx = static_cast<std::int32_t>(std::lround(std::ldexp(unit.x, 30)));
  g.dy = static_cast<std::int32_t>(std::lround(std::ldexp(unit.y, 30)));
}

}  // namespace

sw::FeedLimits feed_limits(const ideal::FeedProfile::Limits& limits, const FeedUnits& units) {
  const double scale = units.point_s * units.point_s / units.count_m;
  const double most = std::max(limits.accel_x, limits.accel_y);
  require(most * scale < kMostAccel,
          fmt::format("path.accel_m_s2: value {:g} is {:g} counts in the square of the {:g} s of a "
                      "point, which must be below {:g}", most, most * scale, units.point_s,
                      kMostAccel));
  return {fixed(limits.accel_x * scale, sw::kFeedBits),
          fixed(limits.accel_y * scale, sw::kFeedBits), word(limits.mean)};
}

std::vector<sw::FeedSegment> feed_segments(const ideal::Moves& moves, const FeedUnits& units) {
  std::vector<sw::FeedSegment> all;
  const double count = units.count_m;
  const auto q32 = [count](const ideal::Place& p) {
    return sw::Vec{std::llround(std::ldexp(p.x / count, 32)),
                   std::llround(std::ldexp(p.y / count, 32))};
  };
  for (std::size_t k = 0; k < moves.moves.size(); ++k) {
    const ideal::Move& m = moves.moves[k];
    sw::FeedSegment g;
    const double length = m.length() / count, speed = m.feed * units.point_s / count;
    for (const double at : {m.from.x, m.from.y, m.to.x, m.to.y}) {
      require(std::abs(at) <= kReach * count,
              fmt::format("path: {:g} m is beyond -{:g}..{:g} m of counts of {:g} m", at,
                          kReach * count, kReach * count, count));
    }
    require(length >= kLeastLength,
            fmt::format("path: a move of {:g} m is shorter than {:g} m", m.length(),
                        kLeastLength * count));
    require(speed < kMostSpeed, fmt::format("path: {:g} m/s is {:g} counts per point, which must "
                                            "be below {:g}", m.feed, speed, kMostSpeed));
    g.length = fixed(length, 32);
    g.feed = std::max<std::uint64_t>(1, fixed(speed, sw::kFeedBits));
    g.end = {q8(m.to.x / count), q8(m.to.y / count)};
    g.dwell = static_cast<std::uint32_t>(
        std::max(0.0, std::ceil(m.dwell / units.point_s - 1.0 / 1024)));
    g.stop = m.stop;
    g.exact = m.exact;
    if (m.kind == ideal::Move::Kind::kLine) {
      g.origin = q32(m.from);
      direct(g, tangent(m, false));
    } else {
      const double radius = m.radius() / count;
      require(radius >= 1 && radius <= kMaxRadius,
              fmt::format("path: an arc with a radius of {:g} m; {:g}..{:g} m are permitted",
                          m.radius(), count, kMaxRadius * count));
      g.radius = fixed(radius, 32);
      g.left = m.sweep > 0;
      const bool flat = g.radius > sw::kFlatRadius;
      g.origin = q32(flat ? m.from : m.center);
      g.rate = static_cast<std::uint64_t>(std::ldexp(1 / (flat ? radius : 2 * kPi * radius), 64));
      const double turns = std::atan2(m.from.y - m.center.y, m.from.x - m.center.x) / (2 * kPi);
      if (flat) {
        direct(g, tangent(m, false));
      } else {
        g.angle = static_cast<std::uint32_t>(std::llround(std::ldexp(turns, 32)));
      }
      require(!flat || std::abs(m.sweep) < kMaxFlat,
              fmt::format("path: an arc of {:g} m with a radius of {:g} m is too long", m.length(),
                          m.radius()));
    }
    if (k + 1 < moves.moves.size()) {
      const ideal::Place a = tangent(m, true), b = tangent(moves.moves[k + 1], false);
      g.half_sine = fixed(std::min(1.0, std::hypot(b.x - a.x, b.y - a.y) / 2), 62);
    }
    all.push_back(g);
  }
  return all;
}

FeedProgram feed_program(const ideal::Moves& moves, const ideal::FeedProfile::Limits& limits,
                         double count_m) {
  const FeedUnits units{count_m, limits.period};
  FeedProgram p;
  require(!moves.moves.empty(), "path: no motion in the program");
  require(moves.moves.size() <= sw::kMaxSegments,
          fmt::format("path: more than {} lines and arcs", sw::kMaxSegments));
  double fastest = 0;
  for (const ideal::Move& m : moves.moves) fastest = std::max(fastest, m.feed);
  const double window = limits.mean * fastest * limits.period / count_m;
  require(window < kMostWindow,
          fmt::format("path.mean_points: value {}: {:g} m/s over as many points are {:g} counts, "
                      "which must be below {:g}", limits.mean, fastest, window, kMostWindow));
  p.moves = moves;
  p.segments = feed_segments(moves, units);
  const std::size_t n = p.segments.size();
  std::vector<sw::FeedPiece> pieces(3 * n + 1);
  p.phases.resize(10 * n + 1);
  sw::FeedPlanner planner({p.segments.data(), static_cast<std::uint32_t>(n), p.phases.data(),
                           static_cast<std::uint32_t>(p.phases.size()), pieces.data(),
                           static_cast<std::uint32_t>(pieces.size())},
                          feed_limits(limits, units));
  while (planner.step() == sw::FeedPlanner::State::kBusy) {
  }
  require(planner.state() == sw::FeedPlanner::State::kDone,
          "path: its time is above 2^30 points");
  p.phases.resize(planner.phases());
  p.setup.segments = p.segments.data();
  p.setup.n_segments = static_cast<std::uint32_t>(n);
  p.setup.phases = p.phases.data();
  p.setup.n_phases = planner.phases();
  p.setup.start = {q8(moves.start.x / count_m), q8(moves.start.y / count_m)};
  p.setup.begin = static_cast<std::uint32_t>(
      std::max(0.0, std::ceil(moves.start_dwell / limits.period - 1.0 / 1024)));
  p.setup.ticks = planner.ticks();
  p.setup.mean = word(limits.mean);
  return p;
}

}  // namespace trammel::kung
