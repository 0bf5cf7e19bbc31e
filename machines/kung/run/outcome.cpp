// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/run/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/kung/chip/measures.hpp"
#include "machines/kung/plan/feed.hpp"
#include "machines/kung/precision/figures.hpp"

namespace trammel::kung {
namespace {

Box box_of(const Walk& walk, double count_m) {
  Box box({walk.low.x * count_m, walk.low.y * count_m});
  box.add({walk.high.x * count_m, walk.high.y * count_m});
  return box;
}

// A square wave is overshot by a quarter of its step, even by the paper's table.
double automatic_limit(const Box& path, bool square, double count_m, double diverged_m) {
  return std::min(std::max(path.diagonal_m() / (square ? 4 : 20), 3 * count_m), diverged_m);
}

double promise_m(const Plan& plan, double count_m) {
  constexpr double kPromisedM = 15e-6;  // docs/precision.md, section 13
  const Options& options = plan.options;
  if (options.controller != Controller::kPrecision) return 0;
  if (!feeds(options) && !plan.file.warnings.empty()) return 0;
  if (options.reached_m > 0) return options.reached_m;
  return std::min(std::max(kPromisedM, 3 * count_m), options.diverged_m);
}

std::string limit_text(double metres) {
  return metres < 1e-3 ? fmt::format("{:.4g} um", 1e6 * metres)
                       : fmt::format("{:.4g} mm", kMm * metres);
}

}  // namespace

std::string length_text(double metres) {
  return metres < 1e-3 ? fmt::format("{:.1f} um", 1e6 * metres)
                       : fmt::format("{:.2f} mm", kMm * metres);
}

void Box::add(const PointM& point) {
  low = {std::min(low.x_m, point.x_m), std::min(low.y_m, point.y_m)};
  high = {std::max(high.x_m, point.x_m), std::max(high.y_m, point.y_m)};
}

double Box::diagonal_m() const { return std::hypot(width_m(), height_m()); }

Outcome::Outcome(const Plan& plan)
    : count_m_(plan.options.plant.axis[0].encoder_count_m),
      path_(box_of(plan.walk, count_m_)),
      covered_(path_.low),
      asked_m_(plan.options.reached_m),
      limit_m_(asked_m_ > 0 ? asked_m_
                            : automatic_limit(path_, plan.options.path.kind == PathKind::kSquare,
                                              count_m_, plan.options.diverged_m)),
      promised_m_(promise_m(plan, count_m_)) {}

void Outcome::add(const PointM& table, double beside_m) {
  if (!begun_) covered_ = Box(table);
  begun_ = true;
  covered_.add(table);
  beside_m_ = std::max(beside_m_, beside_m);
  table_ = table;
}

double Outcome::limit_at_end_m(double lag_m) const {
  if (asked_m_ > 0) return asked_m_;
  return std::max(promised_m_ > 0 ? promised_m_ : limit_m_,
                  std::min(1.25 * lag_m, path_.diagonal_m() / 2));
}

double Outcome::from_m(const PointM& last) const { return tracking_error(last, table_); }

std::string Outcome::missed(std::uint32_t points, std::uint32_t size, const PointM& last,
                            const PointM& lagging, double error_m) const {
  if (points < size) return fmt::format("stopped after {} of {} points", points, size);
  if (promised_m_ > 0 && error_m > promised_m_) {
    return fmt::format("the table was {} from its command, above {} (run.reached_m)",
                       length_text(error_m), limit_text(promised_m_));
  }
  const double at_end = limit_at_end_m(tracking_error(last, lagging));
  if (from_m(last) > at_end) {
    return fmt::format("the table ended {} from the last of {} points, above {} (run.reached_m); "
                       "run.settle_s gives it time",
                       length_text(from_m(last)), size, limit_text(at_end));
  }
  const std::string above = fmt::format(" above {:.4g} mm (run.reached_m)", limit_m_ * kMm);
  if (beside_m_ > limit_m_) {
    return fmt::format("the table was {:.2f} mm beside the path asked,{}", beside_m_ * kMm, above);
  }
  Box covered = covered_;
  covered.add(last);  // from which it is not too far
  const double short_m =
      std::max({covered.low.x_m - path_.low.x_m, covered.low.y_m - path_.low.y_m,
                path_.high.x_m - covered.high.x_m, path_.high.y_m - covered.high.y_m});
  if (short_m <= limit_m_) return "";
  return fmt::format("the table covered {:.2f} x {:.2f} mm of a path of {:.2f} x {:.2f} mm,{}",
                     covered_.width_m() * kMm, covered_.height_m() * kMm, path_.width_m() * kMm,
                     path_.height_m() * kMm, above);
}

std::uint32_t model_lag(const Options& options) {
  const bool precise = options.controller == Controller::kPrecision;
  const double lag_s = precise ? kSetPointDelayS : options.lag_s();
  return static_cast<std::uint32_t>(std::lround(lag_s / options.chip.sample_s()));
}

}  // namespace trammel::kung
