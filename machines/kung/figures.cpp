// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/figures.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

namespace trammel::kung {
namespace {

using kung::PointM;

constexpr double kModelScale = 1.0 / 16384;  // x_m is Q14 of a count

double segment_distance(const PointM& p, const PointM& a, const PointM& b) {
  const double dx = b.x_m - a.x_m;
  const double dy = b.y_m - a.y_m;
  const double length2 = dx * dx + dy * dy;
  double t = 0;
  if (length2 > 0) t = ((p.x_m - a.x_m) * dx + (p.y_m - a.y_m) * dy) / length2;
  t = std::clamp(t, 0.0, 1.0);
  return std::hypot(p.x_m - a.x_m - t * dx, p.y_m - a.y_m - t * dy);
}

}  // namespace

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
    double best = tracking_error(near.front().point, own);
    for (std::size_t i = 0; i + 1 < near.size() && near[i].at <= k + reach; ++i) {
      best = std::min(best, segment_distance(own, near[i].point, near[i + 1].point));
    }
    errors.push_back(best);
  }
  return errors;
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

double model_m(const kung::AxisSample& sample, double count_m) {
  return sample.x_m * kModelScale * count_m;
}

double command_m(const kung::AxisSample& sample, double count_m) { return sample.r * count_m; }

Range counted(const kung::Result& result) {
  Range range;
  const auto& all = result.samples;
  if (result.points == 0) return range;  // no point of the path took effect
  const auto position = [&](std::uint32_t tick) {
    const auto at = std::lower_bound(all.begin(), all.end(), tick,
                                     [](const kung::Sample& s, std::uint32_t t) {
                                       return s.tick < t;
                                     });
    return static_cast<std::size_t>(at - all.begin());
  };
  range.first = position(result.first_tick);
  // A run that ended early has no end tick, or one that was never reached.
  range.last = result.end_tick > result.first_tick ? position(result.end_tick) : all.size();
  return range;
}

Metrics evaluate(const kung::Options& options, const kung::Result& result) {
  Metrics m;
  const Range range = counted(result);
  m.samples = range.last - range.first;
  m.complete = result.end == kung::EndReason::kDone;

  Points table, command;
  Series to_model, to_command;
  std::array<Series, 2> position, model, error_mm;
  for (std::size_t k = range.first; k < range.last; ++k) {
    const auto axes = result.samples[k].axis;
    for (std::size_t a = 0; a < 2; ++a) {
      const double count_m = options.plant.axis[a].encoder_count_m;
      position[a].push_back(axes[a].x_true_m);
      model[a].push_back(model_m(axes[a], count_m));
      error_mm[a].push_back((model[a].back() - axes[a].x_true_m) * kMm);
      AxisMetrics& axis = m.axis[a];
      axis.peak_current_A = std::max(axis.peak_current_A, std::abs(axes[a].i_q_true_A));
      axis.max_speed_m_s = std::max(axis.max_speed_m_s, std::abs(axes[a].v_true_m_s));
    }
    const auto& plant = options.plant.axis;
    table.push_back({axes[0].x_true_m, axes[1].x_true_m});
    command.push_back({command_m(axes[0], plant[0].encoder_count_m),
                       command_m(axes[1], plant[1].encoder_count_m)});
    to_model.push_back(tracking_error({model[0].back(), model[1].back()}, table.back()) * kMm);
    to_command.push_back(tracking_error(command.back(), table.back()) * kMm);
  }
  m.model_mm = spread(to_model);
  m.command_mm = spread(to_command);

  const auto& path = options.path;
  if (path.kind != kung::PathKind::kSquare) {
    Series contour_mm;
    for (const double distance : contour_error(table, command, kContourReach)) {
      contour_mm.push_back(distance * kMm);
    }
    m.contour_mm = spread(contour_mm);
  }
  for (std::size_t a = 0; a < 2; ++a) {
    m.axis[a].model_mm = spread(error_mm[a]);
    if (path.kind == kung::PathKind::kSquare) {
      m.axis[a].halves =
          half_periods(position[a], model[a], static_cast<std::size_t>(path.square_half_samples),
                       path.square_low_m, path.square_high_m);
      m.axis[a].periods = periods(m.axis[a].halves);
    }
  }
  m.simulated_s = cosim::seconds_of(result.clocks, options.plant.clock_ps);
  if (result.wall_s > 0) {
    m.clocks_per_s = static_cast<double>(result.clocks) / result.wall_s;
    m.real_time_factor = m.simulated_s / result.wall_s;
  }
  return m;
}

}  // namespace trammel::kung
