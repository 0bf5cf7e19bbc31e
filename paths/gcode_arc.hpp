// SPDX-License-Identifier: Apache-2.0
//
// Arcs of G-code, whose ends are rounded to the digits of the program: the end has another distance
// from the centre than the start. Of a circle through both ends the centre is moved by as much, so
// that an arc ends where it is said to end and a path has no gap.
#pragma once

#include <vector>

#include "models/ideal/moves.hpp"

namespace trammel::paths {

// Ends nearer to each other could mean a full turn or next to nothing. [m]
constexpr double kNearestArcEnds = 0.5e-6;

// How much the distances of both ends from the centre differ. [m]
double radius_error(const ideal::Place& from, const ideal::Place& to, const ideal::Place& center);

// The arc around the centre, counter-clockwise where `left`; a full turn where the ends are the
// same. Near a full turn two arcs, if their ends differ in radius.
std::vector<ideal::Move> arc_around(const ideal::Place& from, const ideal::Place& to,
                                    const ideal::Place& center, bool left);

// The arc of that radius, not above half a turn where `radius` is above 0, else not below it; of
// half a turn where the radius is too small. The ends differ.
ideal::Move arc_of_radius(const ideal::Place& from, const ideal::Place& to, double radius,
                          bool left);

// The least rectangle along the axes that holds the arc.
struct Extent {
  ideal::Place low, high;
};
Extent arc_extent(const ideal::Move& arc);

}  // namespace trammel::paths
