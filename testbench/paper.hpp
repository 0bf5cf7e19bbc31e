// SPDX-License-Identifier: Apache-2.0
//
// Figures printed by Kung et al. 2012 (DOI 10.5772/48457), and those that the specification expects
// of this machine (section 12) with their tolerances.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "testbench/metrics.hpp"

namespace trammel::testbench {

// One line of a comparison. A missing figure is not printed by that source.
struct Comparison {
  std::string what;
  std::string unit;
  double ours = 0;
  std::optional<double> paper;
  std::optional<double> expected;   // specification section 12, bit-exact model
  double tolerance = 0;             // [unit]

  bool good() const;                // within tolerance, or nothing is expected
};

// True when the run is one of the paper's eight experiments, with nothing but seed, platform,
// name and waves changed.
bool is_paper_experiment(const kung::Options& options);

// Comparison lines of that experiment; empty for any other run.
std::vector<Comparison> compare(const kung::Options& options, const Metrics& metrics);

// What must be said wherever Table 2 is shown (specification section 14.14).
inline constexpr char kCircleNote[] =
    "not reproduced: the paper's 33.3 % smaller spread of the circle under AFC (0.60 -> 0.40)";

}  // namespace trammel::testbench
