// SPDX-License-Identifier: Apache-2.0
//
// Paths for self-paced tracking, as lines and arcs in millimetres: where a length of way along them
// leads, how they bend there, and how far a point lies off them.
#pragma once

#include <string>
#include <vector>

namespace trammel::mcafee {

struct PointMm {
  double x = 0;  // [mm]
  double y = 0;  // [mm]
};

enum class PathKind { kSquare, kCircle, kStar, kCorner, kPoints };

struct PathOptions {
  PathKind kind = PathKind::kSquare;
  double side_mm = 60;    // of the square, of an edge of the star, of a leg of the corner
  double radius_mm = 5;   // of corners and tips, or of the circle
  std::string points_file;  // CSV of x_mm,y_mm
  double row_mm = 0.5;    // length of way of a row, before a whole number of them is made
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

  // At a length of way from the start, 0..length().
  PointMm at(double way) const;
  double curvature(double way) const;  // [1/mm], magnitude; an arc begins with its first point

  // Of a point from the path within `reach` of a length of way.
  double distance(const PointMm& point, double way, double reach) const;

 private:
  struct Segment {
    PointMm from;       // line: begin; arc: centre
    PointMm along;      // line: direction; arc: from the centre to its begin
    double length = 0;  // [mm]
    double radius = 0;  // [mm], 0 of a line
    double turn = 0;    // arc: 1 to the left, -1 to the right
    double begin = 0;   // length of way before it
  };

  void add_line(const PointMm& from, const PointMm& to);
  void add_arc(const PointMm& centre, const PointMm& begin, double angle);
  void add_rounded(const std::vector<PointMm>& corners, double radius, bool closed);
  const Segment& segment(double way) const;
  static PointMm point(const Segment& s, double way);

  std::vector<Segment> segments_;
  bool closed_ = false, sampled_ = false;
  double length_ = 0;
};

}  // namespace trammel::mcafee
