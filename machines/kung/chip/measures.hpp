// SPDX-License-Identifier: Apache-2.0
//
// What figures are made of: spreads of series, distances from paths, and the samples of a record
// that count, with tracking indices as the paper's (specification section 12).
#pragma once

#include <cstddef>
#include <vector>

#include "lab/record.hpp"
#include "machines/kung/chip/record.hpp"

namespace trammel::kung {

// Mean and spread of a series, population form (divided by n).
struct Spread {
  std::size_t n = 0;
  double mean = 0;
  double std = 0;
  double variance = 0;
  double rms = 0;
  double max = 0;
};

// As long as the run, hence on disk as its samples are.
using Series = host::DiskVector<double>;
using Points = host::DiskVector<PointM>;

Spread spread(const Series& series);  // Kung eq. 45, 46

// Distance of p from the line segment between a and b.
double segment_distance(const PointM& p, const PointM& a, const PointM& b);

// Distance between two points (Kung eq. 44).
double tracking_error(const PointM& model, const PointM& table);

inline constexpr double kMm = 1e3;  // in a metre

// Samples within which a contour error looks for its place on the path: three times as long as the
// reference model lags behind a ramp, and at least 250 ms.
std::size_t contour_reach(double lag_s, double sample_s);

// For each point, its distance to the polyline through `path`, searched within `reach` samples of
// the same index, so that where the path crosses itself the other branch is not taken for it.
Series contour_error(const Points& table, const Points& path, std::size_t reach);
// The same, positive to the left of the direction of travel and negative to its right.
Series signed_contour_error(const Points& table, const Points& path, std::size_t reach);

// Samples until a point stays within `band` of `place`; all of them if it never does.
std::size_t settled_after(const Points& points, const PointM& place, double band);

// One half period of a square wave on one axis.
struct HalfPeriod {
  double overshoot_percent = 0;  // largest excursion past the target / step size
  double rms_mm = 0;             // of model output minus position
};

// Half periods of `half` samples each; the first goes to `high`, the next to `low` [m].
std::vector<HalfPeriod> half_periods(const Series& position_m, const Series& model_m,
                                     std::size_t half, double low_m, double high_m);

// Whole periods: of the two halves the worse one counts.
std::vector<HalfPeriod> periods(const std::vector<HalfPeriod>& halves);

// Model output, command and true position of a sample [m].
double model_m(const AxisSample& sample, double count_m);
double command_m(const AxisSample& sample, double count_m);

// Samples that count, [first, last): from the first point to four samples after the last.
using lab::Range;
Range counted(const Result& result);

inline const Options& options_of(const lab::Record& record) {
  return static_cast<const Options&>(*record.settings);
}
inline const Result& result_of(const lab::Record& record) {
  return static_cast<const Result&>(*record.result);
}

}  // namespace trammel::kung
