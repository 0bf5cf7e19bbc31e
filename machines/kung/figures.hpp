// SPDX-License-Identifier: Apache-2.0
//
// Figures of merit of one run. Tracking indices as the paper's (specification section 12).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "lab/record.hpp"
#include "machines/kung/record.hpp"

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

// As long as the run, so kept where the run is.
using Series = cosim::DiskVector<double>;
using Points = cosim::DiskVector<kung::PointM>;

Spread spread(const Series& series);  // Kung eq. 45, 46

// Distance of two points (Kung eq. 44).
double tracking_error(const kung::PointM& model, const kung::PointM& table);

inline constexpr double kMm = 1e3;  // in a metre
inline constexpr std::size_t kContourReach = 500;  // 250 ms; the model lags 67 ms on a ramp

// For each point, its distance to the polyline through `path`, searched within `reach` samples of
// the same index, so that a path that crosses itself is not mistaken for its other branch.
Series contour_error(const Points& table, const Points& path, std::size_t reach);

// One half period of a square wave on one axis.
struct HalfPeriod {
  double overshoot_percent = 0;  // largest excursion past the target / step size
  double rms_mm = 0;             // of model output minus position
};

// Half periods of `half` samples each; the first goes to `high`, the next to `low` [m].
std::vector<HalfPeriod> half_periods(const Series& position_m, const Series& model_m,
                                     std::size_t half, double low_m, double high_m);

// Both halves of a period: the worse one counts.
std::vector<HalfPeriod> periods(const std::vector<HalfPeriod>& halves);

struct AxisMetrics {
  Spread model_mm;               // of the signed error to the model output
  double peak_current_A = 0;
  double max_speed_m_s = 0;
  std::vector<HalfPeriod> halves;   // square wave only
  std::vector<HalfPeriod> periods;
};

struct Metrics {
  std::size_t samples = 0;       // counted: from the first point to four samples after the last
  bool complete = false;         // the whole path was travelled
  Spread model_mm;               // T(k) against the reference model
  Spread command_mm;             // T(k) against the command
  Spread contour_mm;             // distance to the commanded path
  std::array<AxisMetrics, 2> axis;
  double simulated_s = 0;
  double clocks_per_s = 0;
  double real_time_factor = 0;   // simulated / wall time
};

Metrics evaluate(const kung::Options& options, const kung::Result& result);

// Model output, command and true position of a sample [m].
double model_m(const kung::AxisSample& sample, double count_m);
double command_m(const kung::AxisSample& sample, double count_m);

// Samples that count, [first, last).
using lab::Range;
Range counted(const kung::Result& result);

}  // namespace trammel::kung
