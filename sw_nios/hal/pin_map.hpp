// SPDX-License-Identifier: Apache-2.0
//
// Bus for a chip without one: its pins are words, number n at byte 4 n. A write sets the input word
// of that number, a read returns the output word; above them is the platform (platform_map.hpp).
#pragma once

#include <cstdint>

#include "sw_nios/hal/platform_map.hpp"

namespace trammel::sw::pin_map {

constexpr std::uint32_t word(std::uint32_t number) { return 4 * number; }

}  // namespace trammel::sw::pin_map
