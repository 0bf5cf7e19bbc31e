// SPDX-License-Identifier: Apache-2.0
//
// A path under the feed profile: the built-in shapes, or the moves of a program, as the firmware
// takes them (docs/precision.md, "Feed profile"). Throws std::invalid_argument that names the key.
#pragma once

#include "machines/kung/options.hpp"
#include "machines/kung/plan/feed_program.hpp"

namespace trammel::kung {

// The feed profile drives this path: with path.profile = "auto" of the precision controller, of
// programs and of lines. A sweep and a list of points that has its own times are driven point by
// point whatever path.profile says.
bool feeds(const Options& options);

// Position samples for which a point of this path is held: a square wave of steps has one each.
int ticks_per_point(const Options& options);

// Of a shape or of lines through points: path.feed_m_s, or what it is by default.
double feed_m_s(const PathOptions& path);

double highest_feed_m_s(const ideal::Moves& moves);

// Its moves, those of one pass; `read`: of a file.
ideal::Moves feed_moves(const Options& options, const ideal::Moves& read = {});

ideal::FeedProfile::Limits feed_limits(const Options& options);

// The command of the whole path in double precision, every pass of these moves.
ideal::FeedProfile ideal_command(const Options& options, const ideal::Moves& moves);

// Position samples of half a period of a square wave: whole points under the feed profile.
int square_half_samples(const Options& options);

// `program` holds what the set-up points into.
sw::PathSetup plan_feed(const Options& options, FeedProgram& program,
                        const ideal::Moves& read = {});

}  // namespace trammel::kung
