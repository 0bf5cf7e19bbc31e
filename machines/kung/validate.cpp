// SPDX-License-Identifier: Apache-2.0
//
// Rules that concern more than one key.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/kung/plan.hpp"
#include "machines/kung/words.hpp"
#include "cosim/points.hpp"
#include "machines/kung/machine.hpp"

namespace trammel::kung {
namespace {

constexpr cosim::PointRange kStroke{0, 600};  // of the table

struct Box {
  double low[2];
  double high[2];
};

// Where the commanded path lies.
Box extent(const PathOptions& p) {
  switch (p.kind) {
    case PathKind::kCircle: {
      const double r = p.circle_radius_m;
      return {{p.circle_center_x_m - r, p.circle_center_y_m - r},
              {p.circle_center_x_m + r, p.circle_center_y_m + r}};
    }
    case PathKind::kWindow: {
      const double h = p.window_side_m / 2;
      return {{p.window_center_x_m - h, p.window_center_y_m - h},
              {p.window_center_x_m + h, p.window_center_y_m + h}};
    }
    case PathKind::kStar: {  // pentagram of edge a: from (0, 0) over (a, 0), height a cos 18
      const double a = p.star_edge_m;
      const double pi = std::acos(-1.0);
      const double rise = a * std::sin(0.2 * pi);
      return {{p.star_start_x_m, p.star_start_y_m - rise},
              {p.star_start_x_m + a, p.star_start_y_m + a * std::cos(0.1 * pi) - rise}};
    }
    case PathKind::kSquare: {
      const double low = std::min(p.square_low_m, p.square_high_m);
      const double high = std::max(p.square_low_m, p.square_high_m);
      return {{low, low}, {high, high}};
    }
    case PathKind::kLine:
      return {{std::min(p.line_start_x_m, p.line_end_x_m),
               std::min(p.line_start_y_m, p.line_end_y_m)},
              {std::max(p.line_start_x_m, p.line_end_x_m),
               std::max(p.line_start_y_m, p.line_end_y_m)}};
    case PathKind::kPoints: break;
  }
  Box box{{1e9, 1e9}, {-1e9, -1e9}};
  for (const auto& point : p.points) {
    const double at[] = {point.x_m, point.y_m};
    for (int a = 0; a < 2; ++a) {
      box.low[a] = std::min(box.low[a], at[a]);
      box.high[a] = std::max(box.high[a], at[a]);
    }
  }
  return box;
}

void require(bool good, const std::string& message) {
  if (!good) throw lab::ConfigError(message);
}

void check_path(const Options& o) {
  const Box box = extent(o.path);
  for (std::size_t a = 0; a < 2; ++a) {
    const char axis = a == 0 ? 'x' : 'y';
    const auto& plant = o.plant.axis[a];
    const auto& chip = o.chip.axis[a];
    require(plant.stroke_min_m < plant.stroke_max_m,
            fmt::format("plant.{0}.stroke_min_m: must be below plant.{0}.stroke_max_m = {1:g}",
                        axis, plant.stroke_max_m));
    require(!plant.hard_stops ||
                (box.low[a] >= plant.stroke_min_m && box.high[a] <= plant.stroke_max_m),
            fmt::format("path: {} runs from {:.6g} to {:.6g} m, beyond the hard stops "
                        "plant.{}.stroke_min_m..stroke_max_m = {:g}..{:g}",
                        axis, box.low[a], box.high[a], axis, plant.stroke_min_m,
                        plant.stroke_max_m));
    require(chip.stroke_min_m < chip.stroke_max_m,
            fmt::format("chip.{0}.stroke_min_m: must be below chip.{0}.stroke_max_m = {1:g}", axis,
                        chip.stroke_max_m));
    require(chip.dead_time_ns >= o.chip.dead_time_min_ns,
            fmt::format("chip.{}.dead_time_ns: value {} is below chip.dead_time_min_ns = {}", axis,
                        chip.dead_time_ns, o.chip.dead_time_min_ns));
    // The chip's model integrator holds +-131071 counts (section 3).
    const double reach = 131071 * plant.encoder_count_m;
    require(std::max(std::abs(box.low[a]), std::abs(box.high[a])) <= reach,
            fmt::format("path: {} reaches beyond the model's range -{:g}..{:g} m", axis, reach,
                        reach));
    for (const auto& [name, gain] :
         {std::pair{"current_kp_V_A", o.gains[a].current_kp_V_A},
          std::pair{"current_ki_V_A", o.gains[a].current_ki_V_A}}) {
      const double word = current_gain_value(gain, plant.dc_link_v);
      require(word < 64, fmt::format("gains.{}.{}: value {:g} is out of range 0..{:g} at "
                                     "plant.{}.dc_link_V = {:g}",
                                     axis, name, gain, gain * 64 / word, axis, plant.dc_link_v));
    }
  }
}

}  // namespace

void validate(lab::Settings& settings) {
  auto& o = static_cast<Options&>(settings);
  auto& p = o.path;
  if (p.kind == PathKind::kPoints) {
    require(!p.points_file.empty(), "path.points_file: is needed with path.kind = \"points\"");
    try {
      p.points = cosim::read_points_csv(p.points_file, kStroke);
    } catch (const std::invalid_argument& error) {
      throw lab::ConfigError(fmt::format("path.points_file: {}", error.what()));
    }
  }
  require(p.kind != PathKind::kWindow || p.window_side_m > 2 * p.window_radius_m,
          fmt::format("path.window_radius_m: value {:g} is out of range 0..{:g} (half of "
                      "path.window_side_m)",
                      p.window_radius_m, p.window_side_m / 2));
  require(p.kind != PathKind::kSquare || p.square_low_m != p.square_high_m,
          "path.square_high_m: must differ from path.square_low_m");
  check_path(o);
  std::vector<sw::Point> points;
  try {
    plan_firmware(o, points);
  } catch (const std::invalid_argument& error) {
    throw lab::ConfigError(error.what());
  }
}

}  // namespace trammel::kung
