// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/plan/path_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "host/input_file.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/parts.hpp"
#include "paths/gcode.hpp"

namespace trammel::kung {
namespace {

constexpr paths::PointRange kTable{0, 600};         // [mm]
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

paths::GcodeTable gcode_table(const Options& options) {
  const PathOptions& p = options.path;
  const double count_m = options.plant.axis[0].encoder_count_m;
  paths::GcodeTable table;
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

// What rows in their own times ask of the table from one to the next.
class Jumps {
 public:
  Jumps(const Options& options, const std::vector<PointM>& points, const std::vector<int>& lines)
      : options_(options), points_(points), lines_(lines),
        point_s_(options.chip.irq_period_ticks * options.chip.sample_s()) {}

  // The first row with a jump that the chip, or the precision controller's limit, does not have;
  // "" where none has.
  std::string told() const {
    const Encoder encoder{options_.plant.axis[0].encoder_count_m, options_.chip.sample_s()};
    const double feed_m_s = encoder.max_feed_m_s();
    const std::string fast = first(
        [&](std::size_t k, std::size_t a) { return std::abs(way(k, a)) / point_s_; },
        [&](std::size_t) { return feed_m_s; },
        [&](std::size_t k, std::size_t a, double value) {
          return fmt::format("{:.4g} mm of {} since the row before, in {:g} ms, are {:.4g} m/s; {}",
                             1e3 * std::abs(way(k, a)), axis_name(a), 1e3 * point_s_, value,
                             feed_text(encoder));
        });
    if (!fast.empty() || options_.controller != Controller::kPrecision) return fast;
    const auto change = [&](std::size_t k, std::size_t a) {
      return std::abs(way(k + 1, a) - way(k, a)) / point_s_;
    };
    return first([&](std::size_t k, std::size_t a) { return change(k, a) / point_s_; },
                 [&](std::size_t a) { return options_.path.axis[a].accel_m_s2; },
                 [&](std::size_t k, std::size_t a, double value) {
                   return fmt::format("{:.4g} m/s that the speed of {} changes by in {:g} ms are "
                                      "{:.4g} m/s^2; path.{}.accel_m_s2 = {:g}", change(k, a),
                                      axis_name(a), 1e3 * point_s_, value, a == 0 ? 'x' : 'y',
                                      options_.path.axis[a].accel_m_s2);
                 });
  }

 private:
  static char axis_name(std::size_t a) { return a == 0 ? 'X' : 'Y'; }

  // Of an axis to row k, from the one before; before the first and behind the last it rests.
  double way(std::size_t k, std::size_t a) const {
    if (k == 0 || k == points_.size()) return 0;
    return a == 0 ? points_[k].x_m - points_[k - 1].x_m : points_[k].y_m - points_[k - 1].y_m;
  }

  template <class Value, class Limit, class Text>
  std::string first(Value value, Limit limit, Text text) const {
    constexpr double kRounded = 1e-6;  // of the numbers in the file
    std::string told;
    std::size_t more = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      for (const std::size_t a : {0u, 1u}) {
        const double at = value(k, a);
        if (at <= limit(a) * (1 + kRounded)) continue;
        if (!told.empty()) {
          ++more;
        } else {
          told = fmt::format("{}:{}: {}", options_.path.points_file, lines_[k], text(k, a, at));
        }
        break;
      }
    }
    if (more > 0) told += fmt::format("; {} row{} more like it", more, more == 1 ? "" : "s");
    return told;
  }

  const Options& options_;
  const std::vector<PointM>& points_;
  const std::vector<int>& lines_;
  double point_s_;  // for which a row holds
};

PathFile read_points(const Options& options) {
  const PathOptions& path = options.path;
  if (path.points_mode == PointsMode::kPath) require_feed(path, "path.points_mode", "path");
  require(!path.points_file.empty(), "path.points_file: is needed with path.kind = \"points\"");
  try {
    PathFile file;
    std::vector<int> lines;
    file.points = paths::read_points_csv(path.points_file, kTable, &lines);
    if (path.points_mode == PointsMode::kTimed) {
      const std::string jump = Jumps(options, file.points, lines).told();
      if (!jump.empty()) file.warnings.push_back(jump);
    } else {
      file.moves = paths::lines_through(file.points, path.points_file, feed_m_s(path),
                                        path.corner == Corner::kStop);
    }
    return file;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("path.points_file: {}", error.what()));
  }
}

PathFile read_program(const Options& options) {
  const PathOptions& path = options.path;
  require_feed(path, "path.kind", "gcode");
  require(!path.gcode_file.empty(), "path.gcode_file: is needed with path.kind = \"gcode\"");
  try {
    paths::GcodeProgram program = paths::read_gcode_file(path.gcode_file, gcode_table(options));
    return {{}, std::move(program.moves), std::move(program.warnings)};
  } catch (const host::InputError& error) {
    throw std::invalid_argument(fmt::format("path.gcode_file: {}", error.what()));
  }
}

}  // namespace

PathFile read_path_file(const Options& options) {
  if (options.path.kind == PathKind::kPoints) return read_points(options);
  if (options.path.kind == PathKind::kFeed) return read_program(options);
  return {};
}

}  // namespace trammel::kung
