// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/path_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cosim/gcode.hpp"
#include "cosim/input_file.hpp"
#include "machines/kung/plan_feed.hpp"
#include "machines/kung/plan_parts.hpp"

namespace trammel::kung {
namespace {

constexpr cosim::PointRange kTable{0, 600};         // [mm]
constexpr double kMostRadiusCounts = 1 << 20;       // of the firmware's feed profile
constexpr double kShortestCounts = 1.0 / 64;        // it takes a quarter of that
constexpr double kArcRounding = 1.02;               // a centre is moved, see gcode_arc.hpp

// An end of what a program may use, and what ends it there.
struct End {
  double m;
  std::string key;
};

// Of the table, the chip's stroke and the hard stops the nearest.
std::pair<End, End> stroke(const Options& options, std::size_t axis) {
  const AxisChip& chip = options.chip.axis[axis];
  const plant::AxisConfig& plant = options.plant.axis[axis];
  End low{1e-3 * kTable.low_mm, "the table"}, high{1e-3 * kTable.high_mm, "the table"};
  const auto within = [&](const char* section, double min_m, double max_m) {
    const std::string key = fmt::format("{}.{}.stroke_", section, axis == 0 ? 'x' : 'y');
    if (min_m > low.m) low = {min_m, key + "min_m"};
    if (max_m < high.m) high = {max_m, key + "max_m"};
  };
  within("chip", chip.stroke_min_m, chip.stroke_max_m);
  if (plant.hard_stops) within("plant", plant.stroke_min_m, plant.stroke_max_m);
  return {low, high};
}

cosim::GcodeTable gcode_table(const Options& options) {
  const PathOptions& p = options.path;
  const double count_m = options.plant.axis[0].encoder_count_m;
  cosim::GcodeTable table;
  table.start = {p.start_x_m, p.start_y_m};
  table.home = {p.home_x_m, p.home_y_m};
  const auto [low_x, high_x] = stroke(options, 0);
  const auto [low_y, high_y] = stroke(options, 1);
  table.low = {low_x.m, low_y.m};
  table.high = {high_x.m, high_y.m};
  const auto inside = [](const char* key, double m, const End& low, const End& high) {
    in_range(key, m, low.m, high.m, m < low.m ? low.key : high.key);
  };
  inside("path.start_x_m", p.start_x_m, low_x, high_x);
  inside("path.start_y_m", p.start_y_m, low_y, high_y);
  inside("path.home_x_m", p.home_x_m, low_x, high_x);
  inside("path.home_y_m", p.home_y_m, low_y, high_y);
  table.feed_max = p.feed_max_m_s;
  table.feed_max_name = "path.feed_max_m_s";
  table.rapid = p.rapid_m_s;
  table.radius_min = kArcRounding * count_m;
  table.radius_max = std::min(table.radius_max, kMostRadiusCounts * count_m / kArcRounding);
  table.shortest = kShortestCounts * count_m;
  table.exact = p.corner == Corner::kStop;
  return table;
}

void require_feed(const PathOptions& path, const char* key, const char* value) {
  require(path.profile != Profile::kConstant,
          fmt::format("{}: \"{}\" needs path.profile = \"feed\"", key, value));
}

void read_points(Options& options) {
  PathOptions& path = options.path;
  if (path.points_mode == PointsMode::kPath) require_feed(path, "path.points_mode", "path");
  require(!path.points_file.empty(), "path.points_file: is needed with path.kind = \"points\"");
  try {
    path.points = cosim::read_points_csv(path.points_file, kTable);
    if (path.points_mode == PointsMode::kTimed) return;
    path.moves = cosim::lines_through(path.points, path.points_file, feed_m_s(path),
                                      path.corner == Corner::kStop);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("path.points_file: {}", error.what()));
  }
}

void read_program(Options& options) {
  PathOptions& path = options.path;
  require_feed(path, "path.kind", "gcode");
  require(!path.gcode_file.empty(), "path.gcode_file: is needed with path.kind = \"gcode\"");
  try {
    cosim::GcodeProgram program = cosim::read_gcode_file(path.gcode_file, gcode_table(options));
    path.moves = std::move(program.moves);
    path.moves_warnings = std::move(program.warnings);
  } catch (const cosim::InputError& error) {
    throw std::invalid_argument(fmt::format("path.gcode_file: {}", error.what()));
  }
}

}  // namespace

void read_path_files(Options& options) {
  options.path.points.clear();
  options.path.moves = {};
  options.path.moves_warnings.clear();
  if (options.path.kind == PathKind::kPoints) read_points(options);
  if (options.path.kind == PathKind::kFeed) read_program(options);
}

}  // namespace trammel::kung
