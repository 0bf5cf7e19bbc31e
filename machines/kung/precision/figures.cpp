// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/precision/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "machines/kung/chip/measures.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/plan/parts.hpp"
#include "machines/kung/precision/plan.hpp"

namespace trammel::kung {
namespace {

using ideal::Move;
using ideal::Place;

constexpr std::size_t kLapsShown = 8;

double distance_to(const Move& m, const Place& p) {
  if (m.kind == Move::Kind::kLine) {
    return segment_distance({p.x, p.y}, {m.from.x, m.from.y}, {m.to.x, m.to.y});
  }
  const double dx = p.x - m.center.x, dy = p.y - m.center.y;
  const double begin = std::atan2(m.from.y - m.center.y, m.from.x - m.center.x);
  // The angle from the begin of the arc in its own direction, in a turn.
  double along = (std::atan2(dy, dx) - begin) * (m.sweep < 0 ? -1 : 1);
  along -= std::floor(along / (2 * kPi)) * 2 * kPi;
  if (along <= std::abs(m.sweep)) return std::abs(std::hypot(dx, dy) - m.radius());
  return std::min(std::hypot(p.x - m.from.x, p.y - m.from.y),
                  std::hypot(p.x - m.to.x, p.y - m.to.y));
}

// Mean, root mean square, largest and that which 99 % do not exceed.
struct Errors {
  double mean = 0, rms = 0, max = 0, p99 = 0;
};

Errors errors_of(const Series& series) {
  const Spread s = spread(series);
  std::vector<double> sorted(series.begin(), series.end());
  std::sort(sorted.begin(), sorted.end());
  const auto rank = static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(s.n)));
  return {s.mean, s.rms, s.max, sorted[std::max<std::size_t>(rank, 1) - 1]};
}

void add_errors(std::vector<lab::Figure>& list, const std::string& id, const std::string& row,
                const Series& series) {
  const Errors e = errors_of(series);
  list.push_back(lab::figure(id + ".mean", row, "mean", e.mean, "um", 2));
  list.push_back(lab::figure(id + ".rms", row, "rms", e.rms, "um", 2));
  list.push_back(lab::figure(id + ".p99", row, "99 % below", e.p99, "um", 2));
  list.push_back(lab::figure(id + ".max", row, "max", e.max, "um", 2));
}

// At the end: those of the firmware, or what its RTL told the chip.
void add_estimates(std::vector<lab::Figure>& list, const Options& options, const Result& result) {
  if (!result.estimates && result.laws.empty()) return;
  for (std::size_t a = 0; a < 2; ++a) {
    const AxisEstimate found = result.estimates ? (*result.estimates)[a]
                                                : told_estimate(options, a, result.laws.back()[a]);
    const plant::AxisConfig& plant = options.plant.axis[a];
    const std::string axis = a == 0 ? "x" : "y", name = a == 0 ? "X" : "Y";
    const auto add = [&](const char* id, const char* row, double value, bool limited, bool mixed,
                         double truth, const char* unit) {
      const char* what = !found.taught ? "not estimated, start value"
                         : limited     ? "at its limit,"
                         : mixed       ? "not separated,"
                                       : "estimate";
      list.push_back(lab::figure(axis + ".estimate." + id, fmt::format("{} of {}", row, name), what,
                                 value, unit, 2));
      list.push_back(lab::figure(axis + ".estimate." + id + "_true",
                                 fmt::format("{} of {}", row, name), "plant", truth, unit, 2));
    };
    add("mass_kg", "mass", found.mass_kg, found.mass_limited, found.mass_mixed,
        plant.mass_kg + plant.payload_kg, "kg");
    if (found.taught && !found.mass_limited && found.mass_within_kg > 0) {
      list.insert(list.end() - 1, lab::figure(axis + ".estimate.mass_kg_within", "mass of " + name,
                                              "+-", found.mass_within_kg, "kg", 2));
    }
    add("friction_N", "Coulomb friction", found.coulomb_N, found.coulomb_limited,
        found.coulomb_mixed, plant.coulomb_n, "N");
    add("viscous_N_s_m", "viscous friction", found.viscous_N_s_m, found.viscous_limited,
        found.viscous_mixed, plant.viscous_n_s_m, "N s/m");
    if (!result.estimates) continue;  // it was told with the force at one place
    add("cogging_N", "cogging", found.cogging_N(), found.cogging_limited, found.cogging_mixed,
        plant.cogging_n, "N");
    add("force_N", "constant force", found.force_N, found.force_limited, found.force_mixed,
        plant.external_force_n, "N");
  }
}

}  // namespace

double distance_to(const ideal::Moves& moves, const Place& place) {
  double least = std::hypot(place.x - moves.start.x, place.y - moves.start.y);
  for (const Move& m : moves.moves) {
    const double span = m.kind == Move::Kind::kArc ? 2 * m.radius() : m.length();
    if (std::hypot(place.x - m.from.x, place.y - m.from.y) - span > least) continue;
    least = std::min(least, distance_to(m, place));
  }
  return least;
}

double command_time_s(const Options& options, cosim::Clk begin, const Sample& sample) {
  const double clock_s = static_cast<double>(options.run.clock_ps) * 1e-12;
  const double delay_s = options.controller == Controller::kPrecision ? kSetPointDelayS : 0;
  return static_cast<double>(sample.edge - begin) * clock_s - delay_s;
}

void each_command_sample(const Plan& plan, const Result& result,
                         const std::function<void(const CommandSample&)>& take) {
  const Options& options = plan.options;
  if (!feeds(options) || result.points == 0) return;
  const ideal::FeedProfile command = ideal_command(options, plan.moves());
  const Range range = counted(result);
  if (range.first >= result.samples.size()) return;
  const bool precise = options.controller == Controller::kPrecision;
  const cosim::Clk begin = result.samples[range.first].edge;
  for (std::size_t k = range.first; k < range.last; ++k) {
    const Sample sample = result.samples[k];
    CommandSample s;
    s.at = k;
    s.t_s = command_time_s(options, begin, sample);
    if (s.t_s < 0 || s.t_s > command.seconds()) continue;
    s.command = command.at(s.t_s);
    const std::array<double, 2> asked{s.command.p.x, s.command.p.y};
    for (std::size_t a = 0; a < 2; ++a) {
      const AxisSample& axis = sample.axis[a];
      s.error_m[a] = asked[a] - axis.x_true_m;
      if (!precise) continue;
      s.set_point_m[a] =
          axis.set_point * options.plant.axis[a].encoder_count_m / 256 - asked[a];
    }
    take(s);
  }
}

double largest_error_m(const Plan& plan, const Result& result) {
  const Options& options = plan.options;
  double most = 0;
  each_command_sample(plan, result, [&most](const CommandSample& s) {
    most = std::max(most, std::hypot(s.error_m[0], s.error_m[1]));
  });
  if (feeds(options)) return most;
  const Range range = counted(result);
  for (std::size_t k = range.first; k < range.last; ++k) {
    const Sample sample = result.samples[k];
    std::array<double, 2> error_m{};
    for (std::size_t a = 0; a < 2; ++a) {
      const AxisSample& axis = sample.axis[a];
      if (axis.set_point == kNoSetPoint) continue;
      error_m[a] =
          axis.set_point * options.plant.axis[a].encoder_count_m / 256 - axis.x_true_m;
    }
    most = std::max(most, std::hypot(error_m[0], error_m[1]));
  }
  return most;
}

std::vector<std::string> range_lines(const Options& options, const Result& result) {
  constexpr double kWorthTellingS = 0.2;
  constexpr double kMostErrorCounts = 2048;
  std::vector<std::string> lines;
  for (std::size_t a = 0; a < 2; ++a) {
    const plant::AxisConfig& plant = options.plant.axis[a];
    const char axis = a == 0 ? 'x' : 'y', name = a == 0 ? 'X' : 'Y';
    const double mass_s = result.mass_limited[a] * options.chip.sample_s();
    if (result.estimates && mass_s >= kWorthTellingS) {
      lines.push_back(fmt::format("warning: the estimated mass of {} was at the end of its range "
                                  "for {:.3g} s; it is {:.4g} kg, that of the plant {:.4g} kg; "
                                  "precision.{}.mass_kg moves the range", name, mass_s,
                                  (*result.estimates)[a].mass_kg,
                                  plant.mass_kg + plant.payload_kg, axis));
    }
    const double current_s = static_cast<double>(result.load[a].at_current) *
                             options.chip.sample_s();
    if (options.controller == Controller::kPrecision && current_s > 0) {
      lines.push_back(fmt::format("warning: i_q* of {} was at its limit for {:.3g} s: the path "
                                  "asks for more than the motor has", name, current_s));
    }
    const double error_s = result.error_limited[a] * options.chip.sample_s();
    if (error_s > 0) {
      lines.push_back(fmt::format("warning: the error of {} was above the {:.4g} mm that the "
                                  "controller tells for {:.3g} s", name,
                                  1e3 * kMostErrorCounts * plant.encoder_count_m, error_s));
    }
  }
  return lines;
}

void add_command_figures(std::vector<lab::Figure>& list, const Plan& plan, const Result& result) {
  const Options& options = plan.options;
  if (!feeds(options) || result.points == 0) return;
  const ideal::Moves& moves = plan.moves();
  const bool precise = options.controller == Controller::kPrecision;
  Series both, contour, set_point;
  std::array<Series, 2> axes;
  each_command_sample(plan, result, [&](const CommandSample& s) {
    both.push_back(std::hypot(s.error_m[0], s.error_m[1]) * kUm);
    for (std::size_t a = 0; a < 2; ++a) axes[a].push_back(std::abs(s.error_m[a]) * kUm);
    const Place table{s.command.p.x - s.error_m[0], s.command.p.y - s.error_m[1]};
    contour.push_back(distance_to(moves, table) * kUm);
    set_point.push_back(std::hypot(s.set_point_m[0], s.set_point_m[1]) * kUm);
  });
  if (both.empty()) return;
  add_errors(list, "error_um", "error to the command", both);
  add_errors(list, "x.error_um", "of X", axes[0]);
  add_errors(list, "y.error_um", "of Y", axes[1]);
  add_errors(list, "contour_um", "distance to the path", contour);
  if (!precise) return;
  add_errors(list, "set_point_um", "set point of the chip", set_point);
  add_estimates(list, options, result);
  const auto laps = static_cast<std::size_t>(options.path.repeats);
  if (laps < 2 || !result.whole() || both.size() < laps) return;
  for (std::size_t lap = 0; lap < laps; ++lap) {
    Series of_lap;
    for (std::size_t k = lap * both.size() / laps; k < (lap + 1) * both.size() / laps; ++k) {
      of_lap.push_back(both[k]);
    }
    list.push_back(lab::figure(fmt::format("lap_error_um.{}", lap), fmt::format("lap {}", lap + 1),
                               "mean error to the command", spread(of_lap).mean, "um", 2));
    list.back().shown = lap < kLapsShown || lap + 1 == laps;
  }
}

}  // namespace trammel::kung
