// SPDX-License-Identifier: Apache-2.0
//
// Paths for self-paced tracking, as lines and arcs in millimetres, and their tables as McAfee's
// Stage III takes them (1994, App. D, Table 5): rows of constant length, of points that are exact
// and then rounded to counts, half away from zero.
#pragma once

#include <complex>
#include <limits>
#include <string>
#include <vector>

#include "sw_nios/apps/mcafee/mcafee.hpp"

namespace trammel::mcafee {

using PointMm = std::complex<double>;  // x + iy [mm]

enum class PathKind { kSquare, kCircle, kStar, kCorner, kPoints };

struct PathOptions {
  PathKind kind = PathKind::kSquare;
  double side_mm = 60;    // of the square, of an edge of the star, of a leg of the corner
  double radius_mm = 5;   // of corners and tips, or of the circle
  std::string points_file;  // CSV of x_mm,y_mm
  double row_mm = 0.5;    // length of a row, before a whole number of them is made to fit
  double kappa_max_1_mm = 0.2;  // curvature that is C = 255
  int preview_rows = 10;
};

class Path {
 public:
  // Throws cosim::OptionsError for a shape that cannot be; std::invalid_argument for a bad file.
  explicit Path(const PathOptions& options);

  bool closed() const { return closed_; }
  bool sampled() const { return sampled_; }  // of points: no curvature between them
  double length() const { return length_; }  // [mm]

  // At a distance along the path from its start, 0..length().
  PointMm at(double s) const;
  double curvature(double s) const;  // [1/mm], magnitude; an arc begins with its first point

  // Of a point from the path within `reach` of a distance along it. An open path goes straight on
  // at both ends: what is behind its end is not beside it.
  double distance(const PointMm& point, double s, double reach) const;
  // Of a point behind the end of an open path, in the direction in which it ends; 0 of others.
  double behind_end(const PointMm& point) const;

 private:
  struct Segment {
    PointMm from;   // line: begin; arc: centre
    PointMm along;  // line: direction; arc: from the centre to its begin
    double length;  // [mm]
    double radius;  // [mm], 0 of a line, negative of an arc to the right
    double begin;   // distance along the path

    PointMm at(double s) const;
    PointMm ahead(double s) const;  // direction of travel, of length 1
  };

  void add_line(const PointMm& from, const PointMm& to);
  void add_arc(const PointMm& centre, const PointMm& begin, double angle);
  void add_rounded(const std::vector<PointMm>& corners, double radius);
  const Segment& segment(double s) const;

  std::vector<Segment> segments_;
  bool closed_ = false, sampled_ = false;
  double length_ = 0;
};

struct Table {
  std::vector<sw::McafeeRow> rows;
  double row_mm = 0;                  // length of each
  std::vector<std::string> warnings;  // each names its row; rows count from 0
};

// Between the limit switches, from where an axis starts.
struct TravelMm {
  double low = -std::numeric_limits<double>::infinity();  // [mm]
  double high = std::numeric_limits<double>::infinity();
};

// Curvature is analytic, or for points that of the circle through the three at the row. count_mm:
// of an encoder count. Throws as Path does, and cosim::OptionsError naming the row: its increments
// are -127..127 counts, and one of them is not 0. The first row that leaves the travel has a
// warning.
Table make_table(const PathOptions& options, double count_mm, const TravelMm& travel = {});

// The six bytes of each row as McAfee's listing has them in memory, C CC Vx Vy dY dX, a line a row,
// hexadecimal.
std::string listing_text(const Table& table);

// c,cc,vx,vy,dx,dy, a line a row.
std::string table_csv(const Table& table);

}  // namespace trammel::mcafee
