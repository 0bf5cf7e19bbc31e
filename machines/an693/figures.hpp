// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine an693 is judged by.
#pragma once

#include <cstdint>
#include <vector>

#include "machines/an693/record.hpp"

namespace trammel::an693 {

// Samples are counted from the first in which the desired position moves, that being 1.
struct Metrics {
  std::vector<Interrupt> interrupts;  // at which HI rose
  std::int64_t moving_samples = 0;    // until the desired position stood for good
  double moving_s = 0;
  std::int64_t max_error_counts = 0;
  double overshoot_counts = 0;        // beyond the desired position, in the direction of motion
  double settled_s = 0;               // from the first motion until within 2.5 counts, for good or
                                      // until the next
  double max_speed_rev_s = 0;
  double max_voltage_V = 0;
  double max_current_A = 0;
};

Metrics evaluate(const Options& options, const Result& result);

double shaft_counts(const Options& options, const Sample& sample);  // the true angle

}  // namespace trammel::an693
