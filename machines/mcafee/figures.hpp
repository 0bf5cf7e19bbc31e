// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine mcafee is judged by.
#pragma once

#include <cstdint>

#include "machines/mcafee/record.hpp"

namespace trammel::mcafee {

// Of Stage III from the first row on, of the others from the first motion.
struct Metrics {
  double moving_s = 0;             // until the desired position stood for good
  double contour_max_mm = 0;       // distance of the table from the path: its largest,
  double contour_max_s = 0;        // when that was, from the first row on;
  double contour_rms_mm = 0;       // its root mean square while moving,
  double contour_end_mm = 0;       // and at the end
  std::int64_t max_error_counts = 0;  // of an axis
  double max_speed_mm_s = 0;          // of an axis: the table's,
  double max_desired_mm_s = 0;        // and that of the trajectory generator
  double max_current_A = 0;
};

// Also puts into the result where its motion begins, the events, and the contour errors.
Metrics evaluate(const Options& options, Result& result);

}  // namespace trammel::mcafee
