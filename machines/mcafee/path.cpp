// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cosim/machine.hpp"
#include "cosim/points.hpp"
#include "models/plant/trig.hpp"

namespace trammel::mcafee {
namespace {

using plant::kPi;

PointMm operator+(const PointMm& a, const PointMm& b) { return {a.x + b.x, a.y + b.y}; }
PointMm operator-(const PointMm& a, const PointMm& b) { return {a.x - b.x, a.y - b.y}; }
PointMm operator*(double k, const PointMm& a) { return {k * a.x, k * a.y}; }
double dot(const PointMm& a, const PointMm& b) { return a.x * b.x + a.y * b.y; }
double cross(const PointMm& a, const PointMm& b) { return a.x * b.y - a.y * b.x; }
double norm(const PointMm& a) { return std::hypot(a.x, a.y); }
PointMm unit(const PointMm& a) { return 1 / norm(a) * a; }

PointMm turned(const PointMm& a, double turns) {
  const plant::SinCos r = plant::sin_cos_turns(turns);
  return {a.x * r.cos - a.y * r.sin, a.x * r.sin + a.y * r.cos};
}

constexpr double kFarthestMm = 1e4;  // of a coordinate; where the table can go is asked elsewhere

std::vector<PointMm> read_points(const std::string& file) {
  if (file.empty()) {
    throw cosim::OptionsError("path.points_file: is needed with path.kind = \"points\"");
  }
  std::vector<PointMm> points;
  for (const cosim::PointM& p : cosim::read_points_csv(file, {-kFarthestMm, kFarthestMm})) {
    const PointMm next{p.x_m * 1e3, p.y_m * 1e3};
    if (points.empty() || norm(next - points.back()) > 0) points.push_back(next);
  }
  if (points.size() < 2) {
    throw cosim::OptionsError(
        fmt::format("path.points_file: {}: has one point; a path has 2 or more", file));
  }
  return points;
}

// Begins in the middle of its first edge, so that it starts and ends away from a corner.
std::vector<PointMm> from_middle(std::vector<PointMm> corners) {
  corners.insert(corners.begin(), 0.5 * (corners.back() + corners.front()));
  return corners;
}

}  // namespace

Path::Path(const PathOptions& o) {
  const double a = o.side_mm, h = a / 2;
  const double largest = o.kind == PathKind::kSquare   ? h
                         : o.kind == PathKind::kStar   ? h / std::tan(0.4 * kPi)
                         : o.kind == PathKind::kCorner ? a
                                                       : kFarthestMm;
  if (o.radius_mm > largest) {
    throw cosim::OptionsError(
        fmt::format("path.radius_mm: value {:g} is out of range 0..{:.6g} at path.side_mm = {:g}",
                    o.radius_mm, largest, a));
  }
  switch (o.kind) {
    case PathKind::kSquare:
      add_rounded(from_middle({{h, -h}, {h, h}, {-h, h}, {-h, -h}}), o.radius_mm, true);
      break;
    case PathKind::kCircle:
      add_arc({0, 0}, {o.radius_mm, 0}, 2 * kPi);
      closed_ = true;
      break;
    case PathKind::kStar: {  // five edges that cross, and turn by 144 degrees at each tip
      std::vector<PointMm> tips{{h, 0}};
      for (int k = 1; k < 5; ++k) tips.push_back(tips.back() + turned({a, 0}, 0.4 * k));
      add_rounded(from_middle(tips), o.radius_mm, true);
      break;
    }
    case PathKind::kCorner:
      add_rounded({{0, 0}, {a, 0}, {a, a}}, o.radius_mm, false);
      break;
    case PathKind::kPoints: {
      const std::vector<PointMm> points = read_points(o.points_file);
      for (std::size_t k = 1; k < points.size(); ++k) add_line(points[k - 1], points[k]);
      closed_ = points.size() > 3 && norm(points.back() - points.front()) == 0;
      sampled_ = true;
      break;
    }
  }
}

void Path::add_line(const PointMm& from, const PointMm& to) {
  const double length = norm(to - from);
  if (length == 0) return;
  segments_.push_back({from, 1 / length * (to - from), length, 0, 0, length_});
  length_ += length;
}

void Path::add_arc(const PointMm& centre, const PointMm& begin, double angle) {
  const PointMm along = begin - centre;
  const double radius = norm(along);
  const double length = radius * std::fabs(angle);
  if (length == 0) return;
  segments_.push_back({centre, along, length, radius, angle > 0 ? 1.0 : -1.0, length_});
  length_ += length;
}

// Lines between corners, and arcs in them; a closed path begins and ends at its first corner.
void Path::add_rounded(const std::vector<PointMm>& corners, double radius, bool closed) {
  closed_ = closed;
  const std::size_t n = corners.size();
  PointMm at = corners[0];
  for (std::size_t k = 1; k < (closed ? n : n - 1); ++k) {
    const PointMm& corner = corners[k];
    const PointMm in = unit(corner - corners[k - 1]);
    const PointMm out = unit(corners[(k + 1) % n] - corner);
    const double angle = std::atan2(cross(in, out), dot(in, out));
    const double cut = radius * std::tan(std::fabs(angle) / 2);
    const PointMm begin = corner - cut * in;
    const double side = angle > 0 ? radius : -radius;
    add_line(at, begin);
    add_arc(begin + side * PointMm{-in.y, in.x}, begin, angle);
    at = corner + cut * out;
  }
  add_line(at, corners[closed ? 0 : n - 1]);
}

const Path::Segment& Path::segment(double way) const {
  const auto after = std::upper_bound(segments_.begin(), segments_.end(), way,
                                      [](double w, const Segment& s) { return w < s.begin; });
  return after == segments_.begin() ? segments_.front() : *(after - 1);
}

PointMm Path::point(const Segment& s, double way) {
  if (s.radius == 0) return s.from + way * s.along;
  return s.from + turned(s.along, s.turn * way / (2 * kPi * s.radius));
}

PointMm Path::at(double way) const {
  const Segment& s = segment(way);
  return point(s, way - s.begin);
}

double Path::curvature(double way) const {
  const Segment& s = segment(way);
  return s.radius == 0 ? 0 : 1 / s.radius;
}

double Path::distance(const PointMm& p, double way, double reach) const {
  double best = std::numeric_limits<double>::infinity();
  for (const Segment& s : segments_) {
    for (const double lap : {-length_, 0.0, length_}) {
      if (lap != 0 && !closed_) continue;
      const double low = std::max(0.0, way + lap - reach - s.begin);
      const double high = std::min(s.length, way + lap + reach - s.begin);
      if (low > high) continue;
      double nearest = dot(p - s.from, s.along);
      if (s.radius != 0) {
        const PointMm off = p - s.from;
        const double angle = s.turn * std::atan2(cross(s.along, off), dot(s.along, off));
        nearest = (angle < 0 ? angle + 2 * kPi : angle) * s.radius;
      }
      for (const double w : {low, high, std::clamp(nearest, low, high)}) {
        best = std::min(best, norm(p - point(s, w)));
      }
    }
  }
  return best;
}

}  // namespace trammel::mcafee
