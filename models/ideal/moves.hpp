// SPDX-License-Identifier: Apache-2.0
//
// What a program of moves asks of a table, before limits and time: lines and arcs with their feed
// and the stops between them. A reader of G-code or of a list of points writes it; the feed
// profile, in integers and in double precision, takes it. Lengths in metres, angles in radians.
#pragma once

#include <cmath>
#include <vector>

namespace trammel::ideal {

struct Place {
  double x = 0, y = 0;  // [m]
};

struct Move {
  enum class Kind { kLine, kArc };

  Kind kind = Kind::kLine;
  Place from, to;      // an arc of a whole turn ends where it begins
  Place center;        // arc
  double sweep = 0;    // arc: angle [rad], above 0 counter-clockwise, at most a turn
  double feed = 0;     // largest speed along it [m/s]
  bool stop = false;   // the table stops at its end, whatever the corner allows
  bool exact = false;  // exact stop mode: it stops at its end unless the corner is below 1 degree
  double dwell = 0;    // rest at its end before the next move begins [s]; above 0 with `stop` only
  int line = 0;        // of the text it comes from, from 1; 0: none

  double radius() const { return std::hypot(from.x - center.x, from.y - center.y); }
  double length() const {
    return kind == Kind::kArc ? std::abs(sweep) * radius()
                              : std::hypot(to.x - from.x, to.y - from.y);
  }
};

struct Moves {
  Place start;              // where the table rests before the first move
  double start_dwell = 0;   // [s] before the first move
  std::vector<Move> moves;  // each begins where the one before ends; none has the length 0
};

}  // namespace trammel::ideal
