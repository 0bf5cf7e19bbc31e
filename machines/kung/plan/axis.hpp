// SPDX-License-Identifier: Apache-2.0
//
// The words of an axis from physical options (specification sections 3 to 7). Throws
// std::invalid_argument that names the key and the permitted range.
#pragma once

#include <cstddef>

#include "machines/kung/options.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::kung {

sw::AxisSetup plan_axis(const Options& options, std::size_t axis);

}  // namespace trammel::kung
