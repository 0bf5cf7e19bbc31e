// SPDX-License-Identifier: Apache-2.0
//
// Figures of merit of one run, with tracking indices as the paper's (specification section 12), and
// what Kung et al. 2012 (DOI 10.5772/48457) print or the specification expects of them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
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

// What is taken for the values that the paper does not print: those of the defaults, and those of
// the scenarios paper-*, by which Table 2 fits (docs/table2.md).
enum class Reading { kAssumed, kFitted };
inline constexpr std::size_t kReadings = 2;
inline constexpr char kFittedPrefix[] = "paper-";

// By which reading the run is one of the paper's eight experiments, with nothing but seed,
// platform, name and waves changed; none: by neither.
std::optional<Reading> paper_experiment(const Options& options);

// Sets what is printed and expected in the figures of a complete run of such an experiment.
void compare(const Options& options, std::vector<lab::Figure>& figures);

// The controllers of the paper, in the order in which they are told.
inline constexpr std::pair<const char*, Controller> kFuzzy[]{{"AFC", Controller::kAfc},
                                                             {"FC", Controller::kFc}};

// Mean tracking error to the reference model that the paper prints (Kung Table 2) of this path, by
// controller; none of another path.
std::vector<std::pair<std::string, double>> paper_means_mm(const Options& options);

// What must be said wherever Table 2 is shown (specification section 14.14).
std::string circle_note(Reading reading);

}  // namespace trammel::kung
