// SPDX-License-Identifier: Apache-2.0
//
// What holds of all moves that a reader gives: they join, have a length and a speed, and stay in
// the stroke.
#pragma once

#include <cmath>
#include <string>

#include "models/ideal/moves.hpp"

namespace trammel::test {

// What does not hold; "" where all does.
inline std::string moves_problem(const ideal::Moves& all, const ideal::Place& low,
                                 const ideal::Place& high) {
  using ideal::Move;
  using ideal::Place;
  constexpr double kTurn = 2 * 3.14159265358979323846, kSmall = 6e-9;
  const auto inside = [&](const Place& p) {
    return p.x >= low.x - kSmall && p.x <= high.x + kSmall && p.y >= low.y - kSmall &&
           p.y <= high.y + kSmall;
  };
  if (all.moves.empty()) return "no move";
  if (!(all.start_dwell >= 0)) return "a rest below 0";
  Place at = all.start;
  for (const Move& move : all.moves) {
    const std::string where = " in line " + std::to_string(move.line);
    if (move.from.x != at.x || move.from.y != at.y) return "a gap" + where;
    if (!inside(move.from) || !inside(move.to)) return "a point outside" + where;
    if (!(move.length() >= 0.99e-7)) return "no length" + where;
    if (!(move.feed > 0 && move.feed <= 2)) return "no speed" + where;
    if (!(move.dwell >= 0) || (move.dwell > 0 && !move.stop)) return "a rest on the way" + where;
    at = move.to;
    if (move.kind == Move::Kind::kLine) continue;
    if (!(std::abs(move.sweep) <= kTurn + 1e-12)) return "more than a turn" + where;
    const double radius = move.radius();
    const double begin = std::atan2(move.from.y - move.center.y, move.from.x - move.center.x);
    constexpr int kParts = 64;
    for (int k = 0; k <= kParts; ++k) {
      const double angle = begin + move.sweep * k / kParts;
      const Place p{move.center.x + radius * std::cos(angle),
                    move.center.y + radius * std::sin(angle)};
      if (!inside(p)) return "an arc outside" + where;
      const double off = std::hypot(p.x - move.to.x, p.y - move.to.y);
      if (k == kParts && off > kSmall) return "another end" + where;
    }
  }
  return "";
}

}  // namespace trammel::test
