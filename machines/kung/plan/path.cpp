// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/plan/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/parts.hpp"

namespace trammel::kung {
namespace {

constexpr int kMaxTicks = static_cast<int>(sw::kMaxTicks);

// Interrupts for a stretch of that length: enough to stay below the maximum feed.
std::uint32_t ticks_word(const std::string& key, int ticks, double length_m, double point_s,
                         const Encoder& encoder) {
  const double feed = encoder.max_feed_m_s();
  in_range(key, ticks, std::max(1.0, std::ceil(length_m / (feed * point_s) - 1e-9)), kMaxTicks,
           fmt::format("{:g} m, an interrupt each {:g} s (chip.irq_period_ticks), {}", length_m,
                       point_s, feed_text(encoder)));
  return word(ticks);
}

sw::Window::Setup plan_window(const PathOptions& p, double point_s, const Encoder& encoder) {
  in_range("path.window_radius_m", p.window_radius_m, encoder.count_m,
           p.window_side_m / 2 - encoder.count_m, "the straight parts need some length");
  const double half_stroke_m = p.window_side_m / 2 - p.window_radius_m;
  in_range("path.window_step_m", p.window_step_m, half_stroke_m / kMaxTicks,
           std::min(encoder.max_feed_m_s() * point_s, half_stroke_m),
           feed_text(encoder));
  // The step is adjusted so that every part takes whole ticks.
  const double ticks = std::max(1.0, std::round(half_stroke_m / p.window_step_m));
  return {encoder.q32(p.window_center_x_m, p.window_center_y_m), encoder.q32(p.window_side_m / 2),
          encoder.q32(p.window_radius_m), static_cast<std::uint32_t>(ticks),
          ticks_word("path.window_arc_ticks", p.window_arc_ticks, kPi / 2 * p.window_radius_m,
                     point_s, encoder)};
}

void plan_points(int repeats, const PathFile& file, const Encoder& encoder,
                 std::vector<sw::Point>& points) {
  in_range("path.points_file: number of points", static_cast<double>(file.points.size()), 1,
           kMaxTicks);
  points.clear();
  for (const PointM& point : file.points) {
    points.push_back({encoder.counts(point.x_m), encoder.counts(point.y_m)});
  }
  if (!(points.front() == points.back())) {
    in_range("path.repeats", repeats, 1, 1, "the points do not end where they begin");
  }
}

}  // namespace

sw::PathSetup plan_path(const Options& options, const PathFile& file, const Encoder& encoder,
                        PathStore& store) {
  const PathOptions& p = options.path;
  if (feeds(options)) return plan_feed(options, store.feed, file.moves);
  const double point_s = ticks_per_point(options) * encoder.sample_s;
  const auto ticks = [point_s, &encoder](const char* key, int value, double length_m) {
    return ticks_word(key, value, length_m, point_s, encoder);
  };
  const auto q32 = [&encoder](auto... metres) { return encoder.q32(metres...); };
  const auto counts = [&encoder](double metres) { return encoder.counts(metres); };
  sw::PathSetup s;
  s.path = p.kind;
  switch (p.kind) {
    case PathKind::kCircle:
      s.circle = {q32(p.circle_center_x_m, p.circle_center_y_m), q32(p.circle_radius_m),
                  ticks("path.circle_ticks", p.circle_ticks, 2 * kPi * p.circle_radius_m)};
      break;
    case PathKind::kWindow: s.window = plan_window(p, point_s, encoder); break;
    case PathKind::kStar:
      s.star.start = q32(p.star_start_x_m, p.star_start_y_m);
      s.star.edge = q32(p.star_edge_m);
      s.star.stroke_ticks = ticks("path.star_stroke_ticks", p.star_stroke_ticks, p.star_edge_m);
      break;
    case PathKind::kSquare:
      require_step(p);
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
      plan_points(p.repeats, file, encoder, store.points);
      s.points = store.points.data();
      s.n_points = static_cast<std::uint32_t>(store.points.size());
      break;
    case PathKind::kSweep: s.sweep = plan_stepped_sine(options, encoder); break;
    case PathKind::kFeed: break;  // G-code, which the feed profile drives
  }
  const bool square = p.kind == PathKind::kSquare;
  const int repeats = square ? p.square_periods : p.repeats;
  in_range(square ? "path.square_periods" : "path.repeats", repeats, 1,
           std::floor(kMaxPoints / sw::Trajectory(s).size()));
  s.repeats = word(repeats);
  return s;
}

void check_extent(const Options& options, const sw::Point& low, const sw::Point& high) {
  const std::int32_t lows[] = {low.x, low.y};
  const std::int32_t highs[] = {high.x, high.y};
  for (std::size_t a = 0; a < 2; ++a) {
    const char axis = a == 0 ? 'x' : 'y';
    const plant::AxisConfig& plant = options.plant.axis[a];
    const Encoder encoder{plant.encoder_count_m, options.chip.sample_s()};
    const auto inside = [&](double from_m, double to_m, const std::string& what) {
      require(lows[a] >= encoder.counts(from_m) && highs[a] <= encoder.counts(to_m),
              fmt::format("path: {} runs from {:g} to {:g} m, beyond {} = {:g}..{:g}", axis,
                          lows[a] * encoder.count_m, highs[a] * encoder.count_m, what, from_m,
                          to_m));
    };
    const AxisChip& chip = options.chip.axis[a];
    if (plant.hard_stops) {
      inside(plant.stroke_min_m, plant.stroke_max_m,
             fmt::format("the hard stops plant.{}.stroke_min_m..stroke_max_m", axis));
    }
    inside(chip.stroke_min_m, chip.stroke_max_m,
           fmt::format("chip.{}.stroke_min_m..stroke_max_m", axis));
  }
}

}  // namespace trammel::kung
