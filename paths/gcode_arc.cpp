// SPDX-License-Identifier: Apache-2.0
#include "paths/gcode_arc.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trammel::paths {
namespace {

using ideal::Move;
using ideal::Place;

constexpr double kArcPi = 3.14159265358979323846;
// Above this angle the ends are nearer than the radius and hardly say where the centre is.
constexpr double kFittedTurn = 5 * kArcPi / 3;
constexpr double kSameRadius = 5e-9;  // [m], a thousandth of an encoder count

double distance(const Place& a, const Place& b) { return std::hypot(a.x - b.x, a.y - b.y); }

double angle_about(const Place& center, const Place& at) {
  return std::atan2(at.y - center.y, at.x - center.x);
}

// Into 0..2 pi.
double turned(double angle) {
  const double rest = std::fmod(angle, 2 * kArcPi);
  return rest < 0 ? rest + 2 * kArcPi : rest;
}

Move arc(const Place& from, const Place& to, const Place& center, double sweep) {
  Move move;
  move.kind = Move::Kind::kArc;
  move.from = from;
  move.to = to;
  move.center = center;
  move.sweep = sweep;
  return move;
}

// Its centre lies on the line that has both ends at the same distance, `inside` from their chord,
// below 0 on the other side: the arc is above half a turn.
Move arc_of_chord(const Place& from, const Place& to, double inside, bool left) {
  const double chord = distance(from, to), side = left ? 1 : -1;
  const double away = side * inside / chord;
  const Place center{(from.x + to.x) / 2 - away * (to.y - from.y),
                     (from.y + to.y) / 2 + away * (to.x - from.x)};
  return arc(from, to, center, side * 2 * std::atan2(chord / 2, inside));
}

Move fitted(const Place& from, const Place& to, const Place& center, bool left) {
  const double cross = (to.x - from.x) * (center.y - from.y) -
                       (to.y - from.y) * (center.x - from.x);
  return arc_of_chord(from, to, (left ? cross : -cross) / distance(from, to), left);
}

}  // namespace

double radius_error(const Place& from, const Place& to, const Place& center) {
  return std::abs(distance(from, center) - distance(to, center));
}

std::vector<Move> arc_around(const Place& from, const Place& to, const Place& center, bool left) {
  const double side = left ? 1 : -1;
  if (from.x == to.x && from.y == to.y) return {arc(from, to, center, side * 2 * kArcPi)};
  const double begin = angle_about(center, from);
  const double turn = turned(side * (angle_about(center, to) - begin));
  if (turn <= kFittedTurn) return {fitted(from, to, center, left)};
  if (radius_error(from, to, center) <= kSameRadius) return {arc(from, to, center, side * turn)};
  const double radius = (distance(from, center) + distance(to, center)) / 2;
  const double half = begin + side * turn / 2;
  const Place middle{center.x + radius * std::cos(half), center.y + radius * std::sin(half)};
  return {fitted(from, middle, center, left), fitted(middle, to, center, left)};
}

Move arc_of_radius(const Place& from, const Place& to, double radius, bool left) {
  const double half = distance(from, to) / 2;
  const double inside = std::sqrt(std::max(0.0, (std::abs(radius) - half) *
                                                    (std::abs(radius) + half)));
  return arc_of_chord(from, to, radius > 0 ? inside : -inside, left);
}

Extent arc_extent(const Move& arc) {
  Extent all{{std::min(arc.from.x, arc.to.x), std::min(arc.from.y, arc.to.y)},
             {std::max(arc.from.x, arc.to.x), std::max(arc.from.y, arc.to.y)}};
  const double radius = arc.radius(), begin = angle_about(arc.center, arc.from);
  const auto passes = [&](int quarter) {
    const double turn = quarter * kArcPi / 2 - begin;
    return turned(arc.sweep > 0 ? turn : -turn) <= std::abs(arc.sweep);
  };
  if (passes(0)) all.high.x = std::max(all.high.x, arc.center.x + radius);
  if (passes(1)) all.high.y = std::max(all.high.y, arc.center.y + radius);
  if (passes(2)) all.low.x = std::min(all.low.x, arc.center.x - radius);
  if (passes(3)) all.low.y = std::min(all.low.y, arc.center.y - radius);
  return all;
}

}  // namespace trammel::paths
