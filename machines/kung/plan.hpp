// SPDX-License-Identifier: Apache-2.0
//
// Converts physical options to the integers the firmware takes (specification sections 3, 10 and
// 11) and checks every rule that involves more than one option; the range of a single option is in
// keys.cpp. Throws std::invalid_argument that names the key and the permitted range.
#pragma once

#include <vector>

#include "machines/kung/options.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::kung {

// Position samples for which a point of this path is held: the square wave has one each.
int ticks_per_point(const PathOptions& path, int irq_period_ticks);

sw::AxisSetup plan_axis(const Options& options, std::size_t axis);

// `points` receives those of a points path and must live as long as the firmware does.
sw::KungSetup plan_firmware(const Options& options, std::vector<sw::Point>& points);

}  // namespace trammel::kung
