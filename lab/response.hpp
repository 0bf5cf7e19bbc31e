// SPDX-License-Identifier: Apache-2.0
//
// Frequency responses measured tone by tone, and what a control engineer reads from them.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

namespace trammel::lab {

// The part of a series that is a tone of that period: sum of x exp(-j 2 pi k / period).
class ToneSum {
 public:
  explicit ToneSum(std::size_t period) : period_(period) {}
  void add(double x);
  std::complex<double> sum() const { return sum_; }

 private:
  std::size_t period_, k_ = 0;
  std::complex<double> sum_;
};

struct ResponsePoint {
  double hz = 0;
  std::complex<double> gain;
};
using Response = std::vector<ResponsePoint>;  // by rising frequency

// L of a closed loop T = L / (1 + L).
Response opened(const Response& closed);

// A value is there where the measured frequencies enclose it; between them lines over log f.
struct Margins {
  std::optional<double> bandwidth_hz;  // 3 dB below the first point of T
  double peak_db = 0, peak_hz = 0;     // of T
  std::optional<double> crossover_hz, phase_margin_deg;   // where |L| falls through 1
  std::optional<double> reversal_hz, gain_margin_db;      // where L turns through -180 degrees
};

Margins margins(const Response& closed);

double decibel(std::complex<double> gain);
// Phases [degree] without jumps, the first in (-270, 90].
std::vector<double> phases(const Response& response);

}  // namespace trammel::lab
