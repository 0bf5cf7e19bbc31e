// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "cosim/run.hpp"
#include "models/plant/trig.hpp"
#include "paths/points.hpp"

namespace trammel::mcafee {
namespace {

using cosim::OptionsError;
using plant::kPi;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFarthestMm = 1e4;  // of a coordinate; where the table can go is asked elsewhere
constexpr long kMostCounts = 127;    // of an increment
constexpr double kMostRows = 250'000;  // of a table: some 10 MB as text, and seconds of work

double dot(const PointMm& a, const PointMm& b) { return (std::conj(a) * b).real(); }
double cross(const PointMm& a, const PointMm& b) { return (std::conj(a) * b).imag(); }

// The unit vector in a direction.
PointMm direction(double turns) {
  const plant::SinCos r = plant::sin_cos_turns(turns);
  return {r.cos, r.sin};
}

std::vector<PointMm> read_points(const std::string& file) {
  if (file.empty()) {
    throw OptionsError("path.points_file: is needed with path.kind = \"points\"");
  }
  std::vector<PointMm> points;
  for (const paths::PointM& p : paths::read_points_csv(file, {-kFarthestMm, kFarthestMm})) {
    const PointMm next{p.x_m * 1e3, p.y_m * 1e3};
    if (points.empty() || next != points.back()) points.push_back(next);
  }
  if (points.size() < 2) {
    throw OptionsError(
        fmt::format("path.points_file: {}: has one point; a path has 2 or more", file));
  }
  return points;
}

// Begins in the middle of its first edge, so that it starts and ends away from a corner.
std::vector<PointMm> from_middle(std::vector<PointMm> corners) {
  corners.insert(corners.begin(), 0.5 * (corners.back() + corners.front()));
  return corners;
}

// Of the circle through three points: 4 times the triangle's area over the product of its sides.
// Infinite where the path turns back on itself.
double curvature_through(const PointMm& a, const PointMm& b, const PointMm& c) {
  const double area2 = cross(b - a, c - a);
  const double sides = std::abs(b - a) * std::abs(c - b) * std::abs(a - c);
  const double onward = dot(b - a, c - b);
  constexpr double kStraight = 1e-9;  // of the product of two rows
  if (onward < 0 && std::fabs(area2) < -kStraight * onward) return kInfinity;
  return sides == 0 ? 0 : 2 * std::fabs(area2) / sides;
}

}  // namespace

Path::Path(const PathOptions& o) {
  const double a = o.side_mm, h = a / 2;
  const double largest = o.kind == PathKind::kSquare   ? h
                         : o.kind == PathKind::kStar   ? h / std::tan(0.4 * kPi)
                         : o.kind == PathKind::kCorner ? a
                                                       : kFarthestMm;
  if (o.radius_mm > largest) {
    throw OptionsError(
        fmt::format("path.radius_mm: value {:g} is out of range 0..{:.6g} at path.side_mm = {:g}",
                    o.radius_mm, largest, a));
  }
  closed_ = o.kind != PathKind::kCorner;
  switch (o.kind) {
    case PathKind::kSquare:
      add_rounded(from_middle({{h, -h}, {h, h}, {-h, h}, {-h, -h}}), o.radius_mm);
      break;
    case PathKind::kCircle: add_arc({0, 0}, {o.radius_mm, 0}, 2 * kPi); break;
    case PathKind::kStar: {  // five edges that cross, and turn by 144 degrees at each tip
      std::vector<PointMm> tips{{h, 0}};
      for (int k = 1; k < 5; ++k) tips.push_back(tips.back() + a * direction(0.4 * k));
      add_rounded(from_middle(tips), o.radius_mm);
      break;
    }
    case PathKind::kCorner: add_rounded({{0, 0}, {a, 0}, {a, a}}, o.radius_mm); break;
    case PathKind::kPoints: {
      const std::vector<PointMm> points = read_points(o.points_file);
      for (std::size_t k = 1; k < points.size(); ++k) add_line(points[k - 1], points[k]);
      closed_ = points.size() > 3 && points.back() == points.front();
      sampled_ = true;
      break;
    }
  }
}

void Path::add_line(const PointMm& from, const PointMm& to) {
  const double length = std::abs(to - from);
  if (length == 0) return;
  segments_.push_back({from, 1 / length * (to - from), length, 0, length_});
  length_ += length;
}

void Path::add_arc(const PointMm& centre, const PointMm& begin, double angle) {
  const double radius = std::abs(begin - centre);
  const double length = radius * std::fabs(angle);
  if (length == 0) return;
  segments_.push_back({centre, begin - centre, length, std::copysign(radius, angle), length_});
  length_ += length;
}

// Lines between corners, and arcs in them; a closed path begins and ends at its first corner.
void Path::add_rounded(const std::vector<PointMm>& corners, double radius) {
  const std::size_t n = corners.size();
  PointMm at = corners[0];
  for (std::size_t k = 1; k < (closed_ ? n : n - 1); ++k) {
    const PointMm in = corners[k] - corners[k - 1], out = corners[(k + 1) % n] - corners[k];
    const PointMm ahead = 1 / std::abs(in) * in, onward = 1 / std::abs(out) * out;
    const double angle = std::arg(std::conj(ahead) * onward);
    const double cut = radius * std::tan(std::fabs(angle) / 2);
    const PointMm begin = corners[k] - cut * ahead;
    add_line(at, begin);
    add_arc(begin + PointMm{0, std::copysign(radius, angle)} * ahead, begin, angle);
    at = corners[k] + cut * onward;
  }
  add_line(at, corners[closed_ ? 0 : n - 1]);
}

const Path::Segment& Path::segment(double s) const {
  const auto after = std::upper_bound(segments_.begin(), segments_.end(), s,
                                      [](double w, const Segment& one) { return w < one.begin; });
  return after == segments_.begin() ? segments_.front() : *(after - 1);
}

PointMm Path::Segment::at(double s) const {
  return from + (radius == 0 ? s * along : along * direction(s / (2 * kPi * radius)));
}

PointMm Path::at(double s) const { return segment(s).at(s - segment(s).begin); }

PointMm Path::Segment::ahead(double s) const {
  if (radius == 0) return along;
  return along * direction(s / (2 * kPi * radius)) * PointMm{0, 1 / radius};
}

double Path::curvature(double s) const {
  const double radius = segment(s).radius;
  return radius == 0 ? 0 : 1 / std::fabs(radius);
}

double Path::behind_end(const PointMm& p) const {
  if (closed_) return 0;
  const Segment& last = segments_.back();
  return std::max(0.0, dot(p - last.at(last.length), last.ahead(last.length)));
}

double Path::distance(const PointMm& p, double s, double reach) const {
  double best = kInfinity;
  if (!closed_) {
    const Segment &first = segments_.front(), &last = segments_.back();
    const PointMm from_start = p - first.at(0), from_end = p - last.at(last.length);
    if (s <= reach && dot(from_start, first.ahead(0)) < 0) {
      best = std::fabs(cross(first.ahead(0), from_start));
    }
    if (s >= length_ - reach && dot(from_end, last.ahead(last.length)) > 0) {
      best = std::min(best, std::fabs(cross(last.ahead(last.length), from_end)));
    }
  }
  for (const Segment& one : segments_) {
    for (const double lap : {-length_, 0.0, length_}) {
      if (lap != 0 && !closed_) continue;
      const double low = std::max(0.0, s + lap - reach - one.begin);
      const double high = std::min(one.length, s + lap + reach - one.begin);
      if (low > high) continue;
      double nearest = dot(p - one.from, one.along);
      if (one.radius != 0) {
        const double angle = std::copysign(1, one.radius) *
                             std::arg(std::conj(one.along) * (p - one.from));
        nearest = (angle < 0 ? angle + 2 * kPi : angle) * std::fabs(one.radius);
      }
      for (const double w : {low, high, std::clamp(nearest, low, high)}) {
        best = std::min(best, std::abs(p - one.at(w)));
      }
    }
  }
  return best;
}

Table make_table(const PathOptions& options, double count_mm, const TravelMm& travel) {
  const Path path(options);
  const double asked = std::max(1.0, std::round(path.length() / options.row_mm));
  if (asked > kMostRows) {
    throw OptionsError(fmt::format(
        "path.row_mm: a path of {:.8g} mm has {:.0f} rows of {:g} mm; a table has at most {:.0f}: "
        "rows of {:.4g} mm or longer, or a shorter path",
        path.length(), asked, options.row_mm, kMostRows, path.length() / kMostRows));
  }
  const auto rows = static_cast<std::size_t>(asked);
  Table table;
  table.row_mm = path.length() / static_cast<double>(rows);
  std::vector<PointMm> points;  // at which the rows begin, and the last one ends
  for (std::size_t k = 0; k < rows; ++k) {
    points.push_back(path.at(static_cast<double>(k) * table.row_mm));
  }
  points.push_back(path.at(path.closed() ? 0 : path.length()));
  // Three neighbouring points; at the ends of an open path the first or last three.
  const auto sampled_curvature = [&](std::size_t k) {
    if (rows < 2) return 0.0;
    const std::size_t middle = path.closed() ? k : std::clamp<std::size_t>(k, 1, rows - 1);
    return curvature_through(points[(middle + rows - 1) % rows], points[middle],
                             points[middle + 1]);
  };
  const auto warn = [&table](std::size_t row, const std::string& what) {
    table.warnings.push_back(fmt::format("row {}: {}", row, what));
  };
  table.rows.resize(rows);
  long x = 0, y = 0;  // [count] from the start
  bool within = true;
  for (std::size_t k = 0; k < rows; ++k) {
    sw::McafeeRow& row = table.rows[k];
    const double kappa = path.sampled() ? sampled_curvature(k)
                                        : path.curvature(static_cast<double>(k) * table.row_mm);
    const double c = std::round(255 * kappa / options.kappa_max_1_mm);
    if (std::isinf(c)) {
      warn(k, "the path turns back on itself; C = 255");
    } else if (c > 255) {
      warn(k, fmt::format("curvature {:.4g} 1/mm is above path.kappa_max_1_mm = {:g}; C = 255",
                          kappa, options.kappa_max_1_mm));
    }
    row.c = static_cast<std::uint8_t>(std::min(255.0, c));

    const PointMm from_start = points[k + 1] - points[0];
    const long dx = std::lround(from_start.real() / count_mm) - x;
    const long dy = std::lround(from_start.imag() / count_mm) - y;
    if (std::max(std::labs(dx), std::labs(dy)) > kMostCounts) {
      throw OptionsError(fmt::format(
          "path.row_mm: row {}: increments {}, {} are out of range -127..127 counts; value {:g} "
          "is too long, at most {:.4g} mm",
          k, dx, dy, options.row_mm, kMostCounts * count_mm));
    }
    if (dx == 0 && dy == 0 && table.row_mm > 2 * count_mm) {
      throw OptionsError(fmt::format(
          "path.row_mm: row {}: the path turns back in the middle of the row, and both increments "
          "are 0 counts; a row must end at the turn, none does with value {:g}",
          k, options.row_mm));
    }
    if (dx == 0 && dy == 0) {
      throw OptionsError(fmt::format(
          "path.row_mm: row {}: both increments are 0 counts; rows of {:.4g} mm (value {:g}, on a "
          "path of {:.4g} mm) are too short for counts of {:.4g} mm",
          k, table.row_mm, options.row_mm, path.length(), count_mm));
    }
    const double length = std::hypot(static_cast<double>(dx), static_cast<double>(dy));
    const auto share = [length](long d) {
      return static_cast<std::uint8_t>(
          std::lround(255 * (std::fabs(static_cast<double>(d)) / length)));
    };
    row.vx = share(dx);
    row.vy = share(dy);
    row.dx = static_cast<std::int8_t>(dx);
    row.dy = static_cast<std::int8_t>(dy);

    x += dx;
    y += dy;
    for (const auto& [name, counts] : {std::pair{"x", x}, std::pair{"y", y}}) {
      const double mm = static_cast<double>(counts) * count_mm;
      if (!within || (mm > travel.low && mm < travel.high)) continue;
      within = false;
      warn(k, fmt::format("{} = {:.4g} mm from the start is at a limit switch or beyond, out of "
                          "range {:g}..{:g} mm; the program ends there",
                          name, mm, travel.low, travel.high));
    }
  }
  const auto preview = static_cast<std::size_t>(options.preview_rows);
  for (std::size_t k = 0; k < rows; ++k) {
    const std::size_t ahead =
        path.closed() ? (k + preview) % rows : std::min(k + preview, rows - 1);
    table.rows[k].cc = static_cast<std::uint8_t>(std::abs(table.rows[ahead].c - table.rows[k].c));
  }
  return table;
}

std::string listing_text(const Table& table) {
  std::string text;
  for (const sw::McafeeRow& r : table.rows) {
    fmt::format_to(std::back_inserter(text), "{:02X} {:02X} {:02X} {:02X} {:02X} {:02X}\n", r.c,
                   r.cc, r.vx, r.vy, static_cast<std::uint8_t>(r.dy),
                   static_cast<std::uint8_t>(r.dx));
  }
  return text;
}

std::string table_csv(const Table& table) {
  std::string text = "c,cc,vx,vy,dx,dy\n";
  for (const sw::McafeeRow& r : table.rows) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", r.c, r.cc, r.vx, r.vy, r.dx,
                   r.dy);
  }
  return text;
}

}  // namespace trammel::mcafee
