// SPDX-License-Identifier: Apache-2.0
//
// precision.csv of a run of the precision controller: at each position sample, beside trace.csv,
// the error against the command in double precision, that command's speed and acceleration, what
// i_q* is made of, and what the controller takes the axis for beside what it is.
#pragma once

#include <filesystem>
#include <vector>

#include "lab/column.hpp"
#include "machines/kung/chip/record.hpp"
#include "machines/kung/plan/plan.hpp"

namespace trammel::kung {

inline constexpr char kPrecisionTrace[] = "precision.csv";

const std::vector<lab::Column>& precision_columns();

void write_precision(const std::filesystem::path& file, const Plan& plan, const Result& result);

// Parts of i_q* [A], by the words of the law and docs/precision.md, section 4, item 10. Their sum
// is i_q* but for rounding, unless it is saturated.
struct CurrentParts {
  double accel_A = 0, speed_A = 0, friction_A = 0, force_A = 0, feedback_A = 0;
};
CurrentParts parts_of(const AxisLaw& law, double current_full_scale_A);

// What pushes an axis back at a place and time: cogging, external force, load and cable [N].
double pushed_back_N(const plant::AxisConfig& plant, double x_m, double t_s);

}  // namespace trammel::kung
