// SPDX-License-Identifier: Apache-2.0
//
// From physical options to the integers the firmware takes (specification sections 3, 10 and 11).
// All throw std::invalid_argument that names the key and the permitted range.
#pragma once

#include <vector>

#include "machines/kung/record.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::kung {

// Fastest feed [m/s]: the speed words saturate above (section 3), so software keeps below.
inline constexpr double kMaxFeedMS = 1.28;

// 2 kHz samples a point of this path is held: the square wave is always written at 2 kHz.
int ticks_per_point(const PathOptions& path, int irq_period_ticks);

// `points` receives the content of a points path and must live as long as the firmware does.
sw::PathSetup plan_path(const PathOptions& path, int irq_period_ticks,
                        std::vector<sw::Point>& points);

sw::AxisSetup plan_axis(const Options& options, int axis);

// Everything; also checks that the whole path lies inside the strokes of the chip.
sw::KungSetup plan_firmware(const Options& options, std::vector<sw::Point>& points);

}  // namespace trammel::kung
