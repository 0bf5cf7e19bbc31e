// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "cosim/points.hpp"
#include "machines/kung/machine.hpp"
#include "machines/kung/words.hpp"

namespace trammel::kung {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kMaxFeedMS = 1.28;  // the speed words saturate above (section 3)
constexpr int kMaxTicks = static_cast<int>(sw::kMaxTicks);
constexpr int kMaxModelCounts = 131071;  // the model's integrator holds no more (section 3)
constexpr double kMaxM = 0.65;
constexpr double kMaxPoints = 2147483647;
constexpr cosim::PointRange kTable{0, 600};  // [mm]

// Whole numbers in full: 1048576, not 1.04858e+06.
std::string number_text(double value) {
  return value == std::floor(value) ? fmt::format("{:.0f}", value) : fmt::format("{:g}", value);
}

void require(bool good, const std::string& message) {
  if (!good) throw std::invalid_argument(message);
}

void in_range(const std::string& key, double value, double low, double high,
              const std::string& reason = "") {
  require(value >= low && value <= high,
          fmt::format("{}: value {} is out of range {}..{}{}", key, number_text(value),
                      number_text(low), number_text(high),
                      reason.empty() ? "" : " (" + reason + ")"));
}

sw::Q32 q32(double metres) {
  return static_cast<sw::Q32>(std::llround(std::ldexp(metres / kCountM, 32)));
}

sw::Vec q32(double x_m, double y_m) { return {q32(x_m), q32(y_m)}; }

std::int32_t counts(double metres) {
  return static_cast<std::int32_t>(std::floor(metres / kCountM + 0.5));
}

std::uint32_t word(int value) { return static_cast<std::uint32_t>(value); }

// Interrupts for a stretch of that length: enough to stay below the maximum feed.
std::uint32_t ticks_word(const std::string& key, int ticks, double length_m, double point_s) {
  in_range(key, ticks, std::max(1.0, std::ceil(length_m / (kMaxFeedMS * point_s) - 1e-9)),
           kMaxTicks, "feed at most 1.28 m/s");
  return word(ticks);
}

sw::Window::Setup plan_window(const PathOptions& p, double point_s) {
  in_range("path.window_radius_m", p.window_radius_m, kCountM, p.window_side_m / 2 - kCountM,
           "the straight parts need some length");
  const double half_stroke_m = p.window_side_m / 2 - p.window_radius_m;
  in_range("path.window_step_m", p.window_step_m, half_stroke_m / kMaxTicks,
           std::min(kMaxFeedMS * point_s, half_stroke_m), "feed at most 1.28 m/s");
  // The step is adjusted so that every part takes whole ticks.
  const double ticks = std::max(1.0, std::round(half_stroke_m / p.window_step_m));
  return {q32(p.window_center_x_m, p.window_center_y_m), q32(p.window_side_m / 2),
          q32(p.window_radius_m), static_cast<std::uint32_t>(ticks),
          ticks_word("path.window_arc_ticks", p.window_arc_ticks, kPi / 2 * p.window_radius_m,
                     point_s)};
}

void plan_points(const PathOptions& p, std::vector<sw::Point>& points) {
  in_range("path.points_file: number of points", static_cast<double>(p.points.size()), 1,
           kMaxTicks);
  points.clear();
  for (const PointM& point : p.points) points.push_back({counts(point.x_m), counts(point.y_m)});
  if (!(points.front() == points.back())) {
    in_range("path.repeats", p.repeats, 1, 1, "the points do not end where they begin");
  }
}

sw::PathSetup plan_path(const PathOptions& p, int irq_period_ticks,
                        std::vector<sw::Point>& points) {
  const double point_s = ticks_per_point(p, irq_period_ticks) * kSampleS;
  const auto ticks = [point_s](const char* key, int value, double length_m) {
    return ticks_word(key, value, length_m, point_s);
  };
  sw::PathSetup s;
  s.path = p.kind;
  switch (p.kind) {
    case PathKind::kCircle:
      s.circle = {q32(p.circle_center_x_m, p.circle_center_y_m), q32(p.circle_radius_m),
                  ticks("path.circle_ticks", p.circle_ticks, 2 * kPi * p.circle_radius_m)};
      break;
    case PathKind::kWindow: s.window = plan_window(p, point_s); break;
    case PathKind::kStar:
      s.star.start = q32(p.star_start_x_m, p.star_start_y_m);
      s.star.edge = q32(p.star_edge_m);
      s.star.stroke_ticks = ticks("path.star_stroke_ticks", p.star_stroke_ticks, p.star_edge_m);
      break;
    case PathKind::kSquare:
      require(p.square_low_m != p.square_high_m,
              "path.square_high_m: must differ from path.square_low_m");
      s.square = {{counts(p.square_low_m), counts(p.square_low_m)},
                  {counts(p.square_high_m), counts(p.square_high_m)},
                  word(p.square_half_samples)};
      break;
    case PathKind::kLine:
      s.line = {q32(p.line_start_x_m, p.line_start_y_m), q32(p.line_end_x_m, p.line_end_y_m),
                ticks("path.line_ticks", p.line_ticks,
                      std::hypot(p.line_end_x_m - p.line_start_x_m,
                                 p.line_end_y_m - p.line_start_y_m))};
      break;
    case PathKind::kPoints:
      plan_points(p, points);
      s.points = points.data();
      s.n_points = static_cast<std::uint32_t>(points.size());
      break;
  }
  const bool square = p.kind == PathKind::kSquare;
  const int repeats = square ? p.square_periods : p.repeats;
  in_range(square ? "path.square_periods" : "path.repeats", repeats, 1,
           std::floor(kMaxPoints / sw::Trajectory(s).size()));
  s.repeats = word(repeats);
  return s;
}

sw::Gain gain(const std::string& key, double value, double unit = 1,
              const std::string& reason = "") {
  in_range(key, value, 0, 63.9 / unit, reason);
  const fixed::Gain g = gain_word(value * unit);
  return {g.mant, g.exp};
}

std::uint32_t clocks(int ns, std::int64_t clock_ps) {
  return static_cast<std::uint32_t>((std::int64_t{1000} * ns + clock_ps - 1) / clock_ps);
}

// The whole path must lie within the hard stops, the stroke of the chip and the range of the
// reference model.
void check_extent(const Options& options, const sw::PathSetup& setup) {
  sw::PathSetup once = setup;  // every pass has the same bounds
  once.repeats = 1;
  sw::Trajectory path(once);
  sw::Point low = path.start();
  sw::Point high = low;
  for (std::uint32_t n = path.size(); n > 0; --n) {
    const sw::Point p = path.next();
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const std::int32_t lows[] = {low.x, low.y};
  const std::int32_t highs[] = {high.x, high.y};
  for (std::size_t a = 0; a < 2; ++a) {
    const char axis = a == 0 ? 'x' : 'y';
    const auto inside = [&](double from_m, double to_m, const std::string& what) {
      require(lows[a] >= counts(from_m) && highs[a] <= counts(to_m),
              fmt::format("path: {} runs from {:g} to {:g} m, beyond {} = {:g}..{:g}", axis,
                          lows[a] * kCountM, highs[a] * kCountM, what, from_m, to_m));
    };
    const plant::AxisConfig& plant = options.plant.axis[a];
    const AxisChip& chip = options.chip.axis[a];
    if (plant.hard_stops) {
      inside(plant.stroke_min_m, plant.stroke_max_m,
             fmt::format("the hard stops plant.{}.stroke_min_m..stroke_max_m", axis));
    }
    inside(chip.stroke_min_m, chip.stroke_max_m,
           fmt::format("chip.{}.stroke_min_m..stroke_max_m", axis));
    const double reach_m = kMaxModelCounts * plant.encoder_count_m;
    inside(-reach_m, reach_m, "the range of the reference model");
  }
}

}  // namespace

int ticks_per_point(const PathOptions& path, int irq_period_ticks) {
  return path.kind == PathKind::kSquare ? 1 : irq_period_ticks;
}

sw::AxisSetup plan_axis(const Options& options, std::size_t axis) {
  const AxisGains& g = options.gains[axis];
  const AxisChip& c = options.chip.axis[axis];
  const plant::AxisConfig& plant = options.plant.axis[axis];
  const auto key = [axis](const char* section, const char* name) {
    return fmt::format("{}.{}.{}", section, axis == 0 ? 'x' : 'y', name);
  };
  const double volt_unit = current_gain_value(1, plant.dc_link_v);
  const std::string at_voltage = fmt::format("at {} = {:g}", key("plant", "dc_link_V"),
                                             plant.dc_link_v);

  sw::AxisSetup s;
  s.kp = gain(key("gains", "kp"), g.kp);
  s.ki = gain(key("gains", "ki"), g.ki);
  s.kv = gain(key("gains", "kv"), g.kv);
  s.adapt = options.controller == Controller::kAfc;
  s.eta = s.adapt ? gain(key("gains", "learning_rate") + " as ETA",
                         eta_value(g.learning_rate, g.kp, g.ki, g.kv))
                  : sw::Gain{};
  s.kp_cur = gain(key("gains", "current_kp_V_A"), g.current_kp_V_A, volt_unit, at_voltage);
  s.ki_cur = gain(key("gains", "current_ki_V_A"), g.current_ki_V_A, volt_unit, at_voltage);
  s.shift_e = word(g.shift_e);
  s.shift_de = word(g.shift_de);

  // A0 has 18 bits: solve a0(omega_n) for its largest value.
  const double top = std::ldexp(262143, -32);
  const double zk = g.zeta * 2 / kSampleS * top;
  const double top_omega =
      (zk + std::sqrt(zk * zk + (1 - top) * top * 4 / (kSampleS * kSampleS))) / (1 - top);
  in_range(key("gains", "omega_n_rad_s"), g.omega_n_rad_s, 0.1, top_omega, "A0 has 18 bits");
  const ModelWords model = model_words(g.omega_n_rad_s, g.zeta);
  s.a0 = word(model.a0);
  s.b2 = word(model.b2) & 0xFFFFFFu;

  const double revolutions = g.theta_offset_rad / (2 * kPi);
  s.theta_ofs = static_cast<std::uint32_t>(
      std::llround(std::ldexp(revolutions - std::floor(revolutions), 32)));
  require(c.dead_time_ns >= options.chip.dead_time_min_ns,
          fmt::format("{}: value {} is below chip.dead_time_min_ns = {}",
                      key("chip", "dead_time_ns"), c.dead_time_ns, options.chip.dead_time_min_ns));
  s.dead_time = clocks(c.dead_time_ns, options.plant.clock_ps);
  s.qep_filter = word(c.qep_filter_clk);
  in_range(key("chip", "stroke_min_m"), c.stroke_min_m, -kMaxM, c.stroke_max_m);
  in_range(key("chip", "stroke_max_m"), c.stroke_max_m, c.stroke_min_m, kMaxM);
  s.stroke_min = counts(c.stroke_min_m);
  s.stroke_max = counts(c.stroke_max_m);
  s.stroke_check = c.stroke_check;
  require(plant.stroke_min_m < plant.stroke_max_m,
          fmt::format("{}: must be below {} = {:g}", key("plant", "stroke_min_m"),
                      key("plant", "stroke_max_m"), plant.stroke_max_m));
  s.interpolate = g.interpolate;
  s.feedforward = g.feedforward;
  return s;
}

sw::KungSetup plan_firmware(const Options& options, std::vector<sw::Point>& points) {
  const ChipOptions& chip = options.chip;
  sw::KungSetup s;
  static_cast<sw::PathSetup&>(s) = plan_path(options.path, chip.irq_period_ticks, points);
  for (std::size_t a = 0; a < 2; ++a) s.axis[a] = plan_axis(options, a);
  s.irq_period = word(ticks_per_point(options.path, chip.irq_period_ticks));
  s.watchdog_ticks = word(chip.watchdog_ticks);
  if (s.watchdog_ticks != 0) {
    in_range("chip.watchdog_ticks", s.watchdog_ticks, s.irq_period + 1, 65535,
             "or 0; COMMITs come once per interrupt");
  }
  in_range("chip.current_limit_A", chip.current_limit_A, 0, 2047 * kCurrentLsbA);
  s.current_limit = static_cast<std::uint32_t>(std::lround(chip.current_limit_A / kCurrentLsbA));
  s.dead_time_min = clocks(chip.dead_time_min_ns, options.plant.clock_ps);
  check_extent(options, s);
  return s;
}

void validate(lab::Settings& settings) {
  auto& options = static_cast<Options&>(settings);
  PathOptions& path = options.path;
  std::vector<sw::Point> points;
  try {
    if (path.kind == PathKind::kPoints) {
      require(!path.points_file.empty(), "path.points_file: is needed with path.kind = \"points\"");
      try {
        path.points = cosim::read_points_csv(path.points_file, kTable);
      } catch (const std::invalid_argument& error) {
        throw lab::ConfigError(fmt::format("path.points_file: {}", error.what()));
      }
    }
    plan_firmware(options, points);
  } catch (const std::invalid_argument& error) {
    throw lab::ConfigError(error.what());
  }
}

}  // namespace trammel::kung
