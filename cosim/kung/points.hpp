// SPDX-License-Identifier: Apache-2.0
//
// Points of a path from a text file: two columns x_mm,y_mm, one point a line, at most one header
// line; empty lines and lines that begin with '#' are skipped. Throws std::invalid_argument that
// names file, line and what is permitted.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "cosim/kung/types.hpp"

namespace trammel::kung {

inline constexpr double kPointMinMm = 0;
inline constexpr double kPointMaxMm = 600;  // stroke of the table

std::vector<PointM> read_points_csv(std::istream& text, const std::string& name);
std::vector<PointM> read_points_csv(const std::string& file);

}  // namespace trammel::kung
