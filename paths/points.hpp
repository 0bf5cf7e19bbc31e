// SPDX-License-Identifier: Apache-2.0
//
// Points of a path from a text file: two columns x_mm,y_mm, one point per line, at most one header
// line; empty lines and lines that begin with '#' are skipped. Throws std::invalid_argument that
// names file, line and what is permitted.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "models/ideal/moves.hpp"

namespace trammel::paths {

struct PointM {
  double x_m = 0;
  double y_m = 0;
};

struct PointRange {
  double low_mm = 0, high_mm = 0;
};

// `lines`, if given: the line of each point.
std::vector<PointM> read_points_csv(std::istream& text, const std::string& name,
                                    const PointRange& range, std::vector<int>* lines = nullptr);
std::vector<PointM> read_points_csv(const std::string& file, const PointRange& range,
                                    std::vector<int>* lines = nullptr);

// Lines from point to point, for a table that chooses the time; a point that repeats the one before
// is none. `name` begins messages; `exact`: it stops at every corner of 1 degree and more.
ideal::Moves lines_through(const std::vector<PointM>& points, const std::string& name,
                           double feed_m_s, bool exact);

}  // namespace trammel::paths
