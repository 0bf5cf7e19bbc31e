// SPDX-License-Identifier: Apache-2.0
//
// Moves in metres as the segments that the firmware's feed profile takes, and its look-ahead run
// over them. Conversion only: limits, corners and times are the firmware's.
#pragma once

#include <cstdint>
#include <vector>

#include "models/ideal/feed_profile.hpp"
#include "models/ideal/moves.hpp"
#include "sw_nios/path/feed_plan.hpp"

namespace trammel::kung {

// What a planned path needs to live: PathSetup points into it.
struct FeedProgram {
  ideal::Moves moves;  // of one pass
  std::vector<sw::FeedSegment> segments;
  std::vector<sw::FeedPhase> phases;
  sw::FeedPath::Setup setup;
};

// Of an encoder and the time of a point.
struct FeedUnits {
  double count_m = 5e-6;
  double point_s = 2e-3;
};

sw::FeedLimits feed_limits(const ideal::FeedProfile::Limits& limits, const FeedUnits& units);

std::vector<sw::FeedSegment> feed_segments(const ideal::Moves& moves, const FeedUnits& units);

// Throws std::invalid_argument where a move has what a segment cannot hold.
FeedProgram feed_program(const ideal::Moves& moves, const ideal::FeedProfile::Limits& limits,
                         double count_m);

}  // namespace trammel::kung
