// SPDX-License-Identifier: Apache-2.0
#include "machines/mcafee/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "cosim/machine.hpp"

namespace trammel::mcafee {
namespace {

constexpr long kMostCounts = 127;

// Of the circle through three points: 4 times the triangle's area over the product of its sides.
// Infinite where the way turns back on itself.
double curvature_through(const PointMm& a, const PointMm& b, const PointMm& c) {
  const double area2 = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  const double sides = std::hypot(b.x - a.x, b.y - a.y) * std::hypot(c.x - b.x, c.y - b.y) *
                       std::hypot(a.x - c.x, a.y - c.y);
  const double onward = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
  constexpr double kStraight = 1e-9;  // of the product of two rows
  if (onward < 0 && std::fabs(area2) < -kStraight * onward) {
    return std::numeric_limits<double>::infinity();
  }
  return sides == 0 ? 0 : 2 * std::fabs(area2) / sides;
}

struct Counts {
  long x = 0, y = 0;
};

// The rows lead from the start; the first one that reaches a limit switch has a warning.
void warn_of_switch(Table& table, double count_mm, const TravelMm& travel) {
  Counts at;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    at.x += table.rows[k].dx;
    at.y += table.rows[k].dy;
    for (const auto& [name, counts] : {std::pair{"x", at.x}, std::pair{"y", at.y}}) {
      const double mm = static_cast<double>(counts) * count_mm;
      if (mm > travel.low && mm < travel.high) continue;
      table.warnings.push_back(fmt::format(
          "row {}: {} = {:.4g} mm from the start is at a limit switch or beyond, out of range "
          "{:g}..{:g} mm; the program ends there", k, name, mm, travel.low, travel.high));
      return;
    }
  }
}

}  // namespace

Table make_table(const Path& path, const PathOptions& options, double count_mm,
                 const TravelMm& travel) {
  const auto rows =
      static_cast<std::size_t>(std::max(1.0, std::round(path.length() / options.row_mm)));
  Table table;
  table.row_mm = path.length() / static_cast<double>(rows);
  const auto at = [&](std::size_t k) {
    if (k == rows) return path.at(path.closed() ? 0 : path.length());
    return path.at(static_cast<double>(k) * table.row_mm);
  };
  const PointMm origin = at(0);
  const auto counts = [&](std::size_t k) {
    const PointMm p = at(k);
    return Counts{std::lround((p.x - origin.x) / count_mm),
                  std::lround((p.y - origin.y) / count_mm)};
  };
  // Three neighbouring points; at the ends of an open path the first or last three.
  const auto sampled_curvature = [&](std::size_t k) {
    if (rows < 2) return 0.0;
    if (path.closed()) return curvature_through(at((k + rows - 1) % rows), at(k), at(k + 1));
    const std::size_t middle = std::clamp<std::size_t>(k, 1, rows - 1);
    return curvature_through(at(middle - 1), at(middle), at(middle + 1));
  };
  table.rows.resize(rows);
  Counts here;
  for (std::size_t k = 0; k < rows; ++k) {
    sw::McafeeRow& row = table.rows[k];
    const double kappa = path.sampled() ? sampled_curvature(k)
                                        : path.curvature(static_cast<double>(k) * table.row_mm);
    const double c = std::round(255 * kappa / options.kappa_max_1_mm);
    if (std::isinf(c)) {
      table.warnings.push_back(fmt::format("row {}: the path turns back on itself; C = 255", k));
    } else if (c > 255) {
      table.warnings.push_back(
          fmt::format("row {}: curvature {:.4g} 1/mm is above path.kappa_max_1_mm = {:g}; C = 255",
                      k, kappa, options.kappa_max_1_mm));
    }
    row.c = static_cast<std::uint8_t>(std::min(255.0, c));
    const Counts next = counts(k + 1);
    const long dx = next.x - here.x, dy = next.y - here.y;
    here = next;
    if (std::max(std::labs(dx), std::labs(dy)) > kMostCounts) {
      throw cosim::OptionsError(fmt::format(
          "path.row_mm: row {}: increments {}, {} are out of range -127..127 counts; value {:g} "
          "is too long, at most {:.4g} mm",
          k, dx, dy, options.row_mm, kMostCounts * count_mm));
    }
    if (dx == 0 && dy == 0 && table.row_mm > 2 * count_mm) {
      throw cosim::OptionsError(fmt::format(
          "path.row_mm: row {}: the path turns back in the middle of the row, and both increments "
          "are 0 counts; a row must end at the turn, none does with value {:g}",
          k, options.row_mm));
    }
    if (dx == 0 && dy == 0) {
      throw cosim::OptionsError(fmt::format(
          "path.row_mm: row {}: both increments are 0 counts; rows of {:.4g} mm (value {:g}, on a "
          "path of {:.4g} mm) are too short for counts of {:.4g} mm",
          k, table.row_mm, options.row_mm, path.length(), count_mm));
    }
    const double length = std::hypot(static_cast<double>(dx), static_cast<double>(dy));
    const auto scale = [length](long d) {
      const double share = std::fabs(static_cast<double>(d)) / length;
      return static_cast<std::uint8_t>(std::lround(255 * share));
    };
    row.vx = scale(dx);
    row.vy = scale(dy);
    row.dx = static_cast<std::int8_t>(dx);
    row.dy = static_cast<std::int8_t>(dy);
  }
  warn_of_switch(table, count_mm, travel);
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
