// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/chip/measures.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace trammel::kung {
namespace {

constexpr double kModelScale = 1.0 / 16384;  // x_m is Q14 of a count

double square_distance(const PointM& p, const PointM& a, const PointM& b) {
  const double dx = b.x_m - a.x_m;
  const double dy = b.y_m - a.y_m;
  const double length2 = dx * dx + dy * dy;
  double t = 0;
  if (length2 > 0) t = ((p.x_m - a.x_m) * dx + (p.y_m - a.y_m) * dy) / length2;
  t = std::clamp(t, 0.0, 1.0);
  const double x = p.x_m - a.x_m - t * dx, y = p.y_m - a.y_m - t * dy;
  return x * x + y * y;
}

}  // namespace

double segment_distance(const PointM& p, const PointM& a, const PointM& b) {
  return std::sqrt(square_distance(p, a, b));
}

Spread spread(const Series& series) {
  Spread s;
  s.n = series.size();
  if (series.empty()) return s;
  const double n = static_cast<double>(s.n);
  double sum = 0;
  double squares = 0;
  for (const double t : series) {
    sum += t;
    squares += t * t;
    s.max = std::max(s.max, std::abs(t));
  }
  s.mean = sum / n;  // Kung eq. 45
  s.rms = std::sqrt(squares / n);
  double deviation = 0;
  for (const double t : series) deviation += (t - s.mean) * (t - s.mean);
  s.variance = deviation / n;  // Kung eq. 46 is its root
  s.std = std::sqrt(s.variance);
  return s;
}

double tracking_error(const PointM& model, const PointM& table) {
  // Kung eq. 44
  return std::hypot(model.x_m - table.x_m, model.y_m - table.y_m);
}

Series contour_error(const Points& table, const Points& path, std::size_t reach) {
  Series distances;
  for (const double error : signed_contour_error(table, path, reach)) {
    distances.push_back(std::abs(error));
  }
  return distances;
}

Series signed_contour_error(const Points& table, const Points& path, std::size_t reach) {
  Series errors;
  if (path.empty()) return errors;
  // Commands are held for some samples: keep one vertex each, with the sample it came at.
  // Those within reach of the sample, and the one before them, are at hand.
  struct Vertex {
    PointM point;
    std::size_t at;
  };
  std::deque<Vertex> near{{path.front(), 0}};
  std::size_t ahead = 1;
  for (std::size_t k = 0; k < table.size(); ++k) {
    for (; ahead < path.size() && near.back().at <= k + reach; ++ahead) {
      const PointM point = path[ahead];
      if (point.x_m == near.back().point.x_m && point.y_m == near.back().point.y_m) continue;
      near.push_back({point, ahead});
    }
    while (near.size() > 1 && near[1].at + reach < k) near.pop_front();
    const PointM own = table[k];
    double best = near.size() > 1
                      ? std::numeric_limits<double>::infinity()
                      : square_distance(own, near.front().point, near.front().point);
    bool right = false;
    for (std::size_t i = 0; i + 1 < near.size() && near[i].at <= k + reach; ++i) {
      const PointM& a = near[i].point;
      const PointM& b = near[i + 1].point;
      const double square = square_distance(own, a, b);
      if (square >= best) continue;
      best = square;
      right = (b.x_m - a.x_m) * (own.y_m - a.y_m) < (b.y_m - a.y_m) * (own.x_m - a.x_m);
    }
    errors.push_back(right ? -std::sqrt(best) : std::sqrt(best));
  }
  return errors;
}

std::size_t settled_after(const Points& points, const PointM& place, double band) {
  std::size_t outside = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (tracking_error(place, points[k]) > band) outside = k + 1;
  }
  return outside;
}

std::vector<HalfPeriod> half_periods(const Series& position_m, const Series& model_m,
                                     std::size_t half, double low_m, double high_m) {
  std::vector<HalfPeriod> halves;
  const double step = high_m - low_m;
  for (std::size_t begin = 0; begin + half <= position_m.size(); begin += half) {
    const bool up = halves.size() % 2 == 0;
    const double target = up ? high_m : low_m;
    double past = 0;
    Series error;
    for (std::size_t k = begin; k < begin + half; ++k) {
      const double excursion = (position_m[k] - target) / step;
      past = std::max(past, up ? excursion : -excursion);
      error.push_back((model_m[k] - position_m[k]) * kMm);
    }
    halves.push_back({past * 100, spread(error).rms});
  }
  return halves;
}

std::vector<HalfPeriod> periods(const std::vector<HalfPeriod>& halves) {
  std::vector<HalfPeriod> all;
  for (std::size_t i = 0; i + 1 < halves.size(); i += 2) {
    all.push_back({std::max(halves[i].overshoot_percent, halves[i + 1].overshoot_percent),
                   std::max(halves[i].rms_mm, halves[i + 1].rms_mm)});
  }
  return all;
}

std::size_t contour_reach(double lag_s, double sample_s) {
  return static_cast<std::size_t>(
      std::lround(std::clamp(std::max(0.25, 3 * lag_s) / sample_s, 1.0, 1e6)));
}

double model_m(const AxisSample& sample, double count_m) {
  return sample.x_m * kModelScale * count_m;
}

double command_m(const AxisSample& sample, double count_m) { return sample.r * count_m; }

Range counted(const Result& result) {
  Range range;
  const auto& all = result.samples;
  if (result.points == 0) return range;  // no point of the path took effect
  const auto position = [&](std::uint32_t tick) {
    const auto at = std::lower_bound(all.begin(), all.end(), tick,
                                     [](const Sample& s, std::uint32_t t) {
                                       return s.tick < t;
                                     });
    return static_cast<std::size_t>(at - all.begin());
  };
  range.first = position(result.first_tick);
  // A run that ended early has no end tick, or one that was never reached.
  range.last = result.end_tick > result.first_tick ? position(result.end_tick) : all.size();
  return range;
}

}  // namespace trammel::kung
