// SPDX-License-Identifier: Apache-2.0
//
// The path of a run as the firmware takes it (specification section 10). Throws
// std::invalid_argument that names the key and the permitted range.
#pragma once

#include <vector>

#include "machines/kung/options.hpp"
#include "machines/kung/plan/path_files.hpp"
#include "machines/kung/plan/feed_program.hpp"
#include "sw_nios/path/trajectory.hpp"

namespace trammel::kung {

struct Encoder;  // parts.hpp

// The lists that a set-up points into; they must live as long as the firmware does.
struct PathStore {
  std::vector<sw::Point> points;
  FeedProgram feed;
};

sw::PathSetup plan_path(const Options& options, const PathFile& file, const Encoder& encoder,
                        PathStore& store);

// The whole path, with these corners, must lie within the hard stops and the stroke of the chip,
// which lies within the range of the reference model.
void check_extent(const Options& options, const sw::Point& low, const sw::Point& high);

}  // namespace trammel::kung
