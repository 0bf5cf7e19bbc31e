// SPDX-License-Identifier: Apache-2.0
//
// The one walk along a path ahead of a run: what its points span, and what following them asks of
// motors and supply.
#pragma once

#include <array>

#include "machines/kung/options.hpp"
#include "sw_nios/path/trajectory.hpp"

namespace trammel::kung {

// The most that following the model along the path asks of an axis.
struct Demand {
  double force_N = 0, at_force_m_s = 0;  // largest thrust, and the speed there
  double volt = 0, at_volt_m_s = 0;      // of a phase
  double drop_V = 0;                     // at its resistance
  double speed_m_s = 0;
};

struct Walk {
  sw::Point low, high;             // corners of the rectangle around all points
  std::array<Demand, 2> demand{};  // until run.max_s; none of a sweep, which is not followed
};

Walk walk_path(const Options& options, const sw::PathSetup& setup);

}  // namespace trammel::kung
