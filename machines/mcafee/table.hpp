// SPDX-License-Identifier: Apache-2.0
//
// The table of a path as McAfee's Stage III takes it (1994, App. D, Table 5): rows of constant
// length of way, of points that are exact and then rounded to counts, half away from zero.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "machines/mcafee/path.hpp"
#include "sw_nios/apps/mcafee/mcafee.hpp"

namespace trammel::mcafee {

struct Table {
  std::vector<sw::McafeeRow> rows;
  double row_mm = 0;                  // length of way of each
  std::vector<std::string> warnings;  // each names its row; rows count from 0
};

// Between the limit switches, from where an axis starts.
struct TravelMm {
  double low = -std::numeric_limits<double>::infinity();  // [mm]
  double high = std::numeric_limits<double>::infinity();
};

// Whose curvature is analytic, or for points that of the circle through the three at the row.
// count_mm: of an encoder count. Throws cosim::OptionsError naming the row: its increments are
// -127..127 counts, and one of them is not 0. The first row that leaves the travel has a warning.
Table make_table(const Path& path, const PathOptions& options, double count_mm,
                 const TravelMm& travel = {});

// The six bytes of each row as McAfee's listing has them in memory, C CC Vx Vy dY dX, a line a row,
// hexadecimal.
std::string listing_text(const Table& table);

// c,cc,vx,vy,dx,dy, a line a row.
std::string table_csv(const Table& table);

}  // namespace trammel::mcafee
