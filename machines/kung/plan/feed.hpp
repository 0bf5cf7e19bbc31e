// SPDX-License-Identifier: Apache-2.0
//
// A path under the feed profile: the built-in shapes, or the moves of a program, as the firmware
// takes them (docs/precision.md, "Feed profile"). Throws std::invalid_argument that names the key.
#pragma once

#include "machines/kung/options.hpp"
#include "machines/kung/plan/feed_program.hpp"

namespace trammel::kung {

// What path.profile = "auto" is: feed with the precision controller, and for programs and lines,
// else constant. plan_firmware() does the same for itself.
void choose_profile(Options& options);

// The feed profile drives this path; a sweep and a list of points that has its own times are driven
// point by point whatever path.profile says.
bool feeds(const PathOptions& path);

// Position samples for which a point of this path is held: a square wave of steps has one each.
int ticks_per_point(const PathOptions& path, int irq_period_ticks);

// Of a shape or of lines through points: path.feed_m_s, or what it is by default.
double feed_m_s(const PathOptions& path);

// Highest feed of its moves.
double highest_feed_m_s(const Options& options);

// Its moves, those of one pass.
ideal::Moves feed_moves(const Options& options);

ideal::FeedProfile::Limits feed_limits(const Options& options);

// The command of the whole path in double precision, every pass of it.
ideal::FeedProfile ideal_command(const Options& options);

// Position samples of half a period of a square wave: whole points under the feed profile.
int square_half_samples(const Options& options);

// `program` holds what the set-up points into.
sw::PathSetup plan_feed(const Options& options, FeedProgram& program);

}  // namespace trammel::kung
