// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "machines/kung/words.hpp"

namespace trammel::kung {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kMaxTicks = static_cast<int>(sw::kMaxTicks);
constexpr double kMaxM = 0.65;  // the model integrator holds +-131071 counts (section 3)
constexpr double kMaxPoints = 2147483647;

// Whole numbers in full: 1048576, not 1.04858e+06.
std::string number_text(double value) {
  return value == std::floor(value) ? fmt::format("{:.0f}", value) : fmt::format("{:g}", value);
}

void in_range(const std::string& key, double value, double low, double high,
              const std::string& reason = "") {
  if (value >= low && value <= high) return;
  throw std::invalid_argument(fmt::format("{}: value {} is out of range {}..{}{}", key,
                                          number_text(value), number_text(low), number_text(high),
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

void position(const std::string& key, double metres) { in_range(key, metres, -kMaxM, kMaxM); }

// Steps for a stretch of that length: enough to keep the feed.
void ticks_in_range(const std::string& key, int ticks, double length_m, double point_s,
                    int fewest) {
  const double needed = std::ceil(length_m / (kMaxFeedMS * point_s) - 1e-9);
  in_range(key, ticks, std::max<double>(fewest, needed), kMaxTicks, "feed at most 1.28 m/s");
}

sw::Circle::Setup plan_circle(const PathOptions& p, double point_s) {
  position("path.circle_center_x_m", p.circle_center_x_m);
  position("path.circle_center_y_m", p.circle_center_y_m);
  in_range("path.circle_radius_m", p.circle_radius_m, kCountM, kMaxM);
  ticks_in_range("path.circle_ticks", p.circle_ticks, 2 * kPi * p.circle_radius_m, point_s, 4);
  return {q32(p.circle_center_x_m, p.circle_center_y_m), q32(p.circle_radius_m),
          word(p.circle_ticks)};
}

sw::Window::Setup plan_window(const PathOptions& p, double point_s) {
  position("path.window_center_x_m", p.window_center_x_m);
  position("path.window_center_y_m", p.window_center_y_m);
  in_range("path.window_side_m", p.window_side_m, 4 * kCountM, 2 * kMaxM);
  in_range("path.window_radius_m", p.window_radius_m, kCountM, p.window_side_m / 2 - kCountM,
           "the straight parts need some length");
  const double half_stroke_m = p.window_side_m / 2 - p.window_radius_m;
  in_range("path.window_step_m", p.window_step_m, half_stroke_m / kMaxTicks,
           std::min(kMaxFeedMS * point_s, half_stroke_m), "feed at most 1.28 m/s");
  ticks_in_range("path.window_arc_ticks", p.window_arc_ticks, kPi / 2 * p.window_radius_m, point_s,
                 1);
  // The step is adjusted so that every part takes whole ticks.
  const double ticks = std::max(1.0, std::round(half_stroke_m / p.window_step_m));
  return {q32(p.window_center_x_m, p.window_center_y_m), q32(p.window_side_m / 2),
          q32(p.window_radius_m), static_cast<std::uint32_t>(ticks), word(p.window_arc_ticks)};
}

sw::Star::Setup plan_star(const PathOptions& p, double point_s) {
  position("path.star_start_x_m", p.star_start_x_m);
  position("path.star_start_y_m", p.star_start_y_m);
  in_range("path.star_edge_m", p.star_edge_m, kCountM, 2 * kMaxM);
  ticks_in_range("path.star_stroke_ticks", p.star_stroke_ticks, p.star_edge_m, point_s, 1);
  sw::Star::Setup setup;
  setup.start = q32(p.star_start_x_m, p.star_start_y_m);
  setup.edge = q32(p.star_edge_m);
  setup.stroke_ticks = word(p.star_stroke_ticks);
  return setup;
}

sw::Square::Setup plan_square(const PathOptions& p) {
  position("path.square_low_m", p.square_low_m);
  position("path.square_high_m", p.square_high_m);
  in_range("path.square_half_samples", p.square_half_samples, 1, kMaxTicks);
  const std::int32_t low = counts(p.square_low_m);
  const std::int32_t high = counts(p.square_high_m);
  return {{low, low}, {high, high}, word(p.square_half_samples)};
}

sw::Line::Setup plan_line(const PathOptions& p, double point_s) {
  position("path.line_start_x_m", p.line_start_x_m);
  position("path.line_start_y_m", p.line_start_y_m);
  position("path.line_end_x_m", p.line_end_x_m);
  position("path.line_end_y_m", p.line_end_y_m);
  const double length_m =
      std::hypot(p.line_end_x_m - p.line_start_x_m, p.line_end_y_m - p.line_start_y_m);
  ticks_in_range("path.line_ticks", p.line_ticks, length_m, point_s, 1);
  return {q32(p.line_start_x_m, p.line_start_y_m), q32(p.line_end_x_m, p.line_end_y_m),
          word(p.line_ticks)};
}

void plan_points(const PathOptions& p, std::vector<sw::Point>& points) {
  in_range("path.points: number", static_cast<double>(p.points.size()), 1, kMaxTicks);
  points.clear();
  for (const PointM& point : p.points) {
    const std::string key = "path.points[" + std::to_string(points.size()) + "]";
    position(key + ".x_m", point.x_m);
    position(key + ".y_m", point.y_m);
    points.push_back({counts(point.x_m), counts(point.y_m)});
  }
  if (p.repeats > 1 && !(points.front() == points.back())) {
    in_range("path.repeats", p.repeats, 1, 1, "the points do not end where they begin");
  }
}

double ticks_a_pass(const sw::PathSetup& s) {
  sw::PathSetup one = s;
  one.repeats = 1;
  return sw::Trajectory(one).size();
}

std::string axis_key(const char* section, int axis, const char* name) {
  return std::string(section) + (axis == 0 ? ".x." : ".y.") + name;
}

sw::Gain gain(const std::string& key, double value, double unit = 1) {
  in_range(key, value, 0, 63.9 / unit);
  const fixed::Gain g = gain_word(value * unit);
  return {g.mant, g.exp};
}

std::uint32_t clocks(const std::string& key, int ns, std::int64_t clock_ps) {
  in_range(key, ns, 0, 1023e-3 * static_cast<double>(clock_ps));
  return static_cast<std::uint32_t>((std::int64_t{1000} * ns + clock_ps - 1) / clock_ps);
}

void check_stroke(const Options& options, const sw::KungSetup& setup) {
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
    const sw::AxisSetup& axis = setup.axis[a];
    if (lows[a] >= axis.stroke_min && highs[a] <= axis.stroke_max) continue;
    const char name = a == 0 ? 'x' : 'y';
    throw std::invalid_argument(
        fmt::format("path: {0} runs from {1:g} to {2:g} m, permitted is "
                    "chip.{0}.stroke_min_m..stroke_max_m = {3:g}..{4:g}",
                    name, lows[a] * kCountM, highs[a] * kCountM,
                    options.chip.axis[a].stroke_min_m, options.chip.axis[a].stroke_max_m));
  }
}

}  // namespace

int ticks_per_point(const PathOptions& path, int irq_period_ticks) {
  in_range("chip.irq_period_ticks", irq_period_ticks, 1, 255);
  return path.kind == PathKind::kSquare ? 1 : irq_period_ticks;
}

sw::PathSetup plan_path(const PathOptions& path, int irq_period_ticks,
                        std::vector<sw::Point>& points) {
  const double point_s = ticks_per_point(path, irq_period_ticks) * kSampleS;
  sw::PathSetup s;
  switch (path.kind) {
    case PathKind::kCircle:
      s.path = sw::Path::kCircle;
      s.circle = plan_circle(path, point_s);
      break;
    case PathKind::kWindow:
      s.path = sw::Path::kWindow;
      s.window = plan_window(path, point_s);
      break;
    case PathKind::kStar:
      s.path = sw::Path::kStar;
      s.star = plan_star(path, point_s);
      break;
    case PathKind::kSquare:
      s.path = sw::Path::kSquare;
      s.square = plan_square(path);
      break;
    case PathKind::kLine:
      s.path = sw::Path::kLine;
      s.line = plan_line(path, point_s);
      break;
    case PathKind::kPoints:
      s.path = sw::Path::kPoints;
      plan_points(path, points);
      s.points = points.data();
      s.n_points = static_cast<std::uint32_t>(points.size());
      break;
  }
  const bool square = path.kind == PathKind::kSquare;
  const int repeats = square ? path.square_periods : path.repeats;
  in_range(square ? "path.square_periods" : "path.repeats", repeats, 1,
           std::floor(kMaxPoints / ticks_a_pass(s)));
  s.repeats = word(repeats);
  return s;
}

sw::AxisSetup plan_axis(const Options& options, int axis) {
  const auto at = static_cast<std::size_t>(axis);
  const AxisGains& g = options.gains[at];
  const AxisChip& c = options.chip.axis[at];
  const auto key = [axis](const char* name) { return axis_key("gains", axis, name); };
  const auto chip_key = [axis](const char* name) { return axis_key("chip", axis, name); };
  const double volt_unit = current_gain_value(1, options.plant.axis[at].dc_link_v);

  sw::AxisSetup s;
  s.kp = gain(key("kp"), g.kp);
  s.ki = gain(key("ki"), g.ki);
  s.kv = gain(key("kv"), g.kv);
  const double eta = eta_value(g.learning_rate, g.kp, g.ki, g.kv);
  s.adapt = options.controller == Controller::kAfc;
  s.eta = s.adapt ? gain(key("learning_rate") + " as ETA", eta) : sw::Gain{};
  s.kp_cur = gain(key("current_kp_V_A"), g.current_kp_V_A, volt_unit);
  s.ki_cur = gain(key("current_ki_V_A"), g.current_ki_V_A, volt_unit);
  in_range(key("shift_e"), g.shift_e, 0, 15);
  in_range(key("shift_de"), g.shift_de, 0, 15);
  s.shift_e = word(g.shift_e);
  s.shift_de = word(g.shift_de);

  in_range(key("zeta"), g.zeta, 0.01, 100);
  // A0 has 18 bits: solve a0(omega_n) for its largest value.
  const double top = std::ldexp(262143, -32);
  const double zk = g.zeta * 2 / kSampleS * top;
  const double top_omega =
      (zk + std::sqrt(zk * zk + (1 - top) * top * 4 / (kSampleS * kSampleS))) / (1 - top);
  in_range(key("omega_n_rad_s"), g.omega_n_rad_s, 0.1, top_omega, "A0 has 18 bits");
  const ModelWords model = model_words(g.omega_n_rad_s, g.zeta);
  s.a0 = word(model.a0);
  s.b2 = word(model.b2) & 0xFFFFFFu;

  const double turns = g.theta_offset_rad / (2 * kPi);
  s.theta_ofs = static_cast<std::uint32_t>(std::llround(std::ldexp(turns - std::floor(turns), 32)));
  s.dead_time = clocks(chip_key("dead_time_ns"), c.dead_time_ns, options.plant.clock_ps);
  in_range(chip_key("qep_filter_clk"), c.qep_filter_clk, 1, 15);
  s.qep_filter = word(c.qep_filter_clk);
  in_range(chip_key("stroke_min_m"), c.stroke_min_m, -kMaxM, c.stroke_max_m);
  in_range(chip_key("stroke_max_m"), c.stroke_max_m, c.stroke_min_m, kMaxM);
  s.stroke_min = counts(c.stroke_min_m);
  s.stroke_max = counts(c.stroke_max_m);
  s.stroke_check = c.stroke_check;
  s.interpolate = g.interpolate;
  s.feedforward = g.feedforward;
  return s;
}

sw::KungSetup plan_firmware(const Options& options, std::vector<sw::Point>& points) {
  sw::KungSetup s;
  static_cast<sw::PathSetup&>(s) = plan_path(options.path, options.chip.irq_period_ticks, points);
  for (int a = 0; a < 2; ++a) s.axis[static_cast<std::size_t>(a)] = plan_axis(options, a);
  s.irq_period = word(ticks_per_point(options.path, options.chip.irq_period_ticks));
  in_range("chip.watchdog_ticks", options.chip.watchdog_ticks, 0, 65535);
  s.watchdog_ticks = word(options.chip.watchdog_ticks);
  if (s.watchdog_ticks != 0) {
    in_range("chip.watchdog_ticks", s.watchdog_ticks, s.irq_period + 1, 65535,
             "or 0; COMMITs come once per interrupt");
  }
  in_range("chip.current_limit_A", options.chip.current_limit_A, 0, 2047 * kCurrentLsbA);
  s.current_limit =
      static_cast<std::uint32_t>(std::lround(options.chip.current_limit_A / kCurrentLsbA));
  s.dead_time_min =
      clocks("chip.dead_time_min_ns", options.chip.dead_time_min_ns, options.plant.clock_ps);
  check_stroke(options, s);
  return s;
}

}  // namespace trammel::kung
