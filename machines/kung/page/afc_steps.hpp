// SPDX-License-Identifier: Apache-2.0
//
// What multiplier and adder of rtl/control/afc.sv hold after each of its 35 steps, in one sample
// (specification section 6), by its twin, from the words the sample starts with.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "machines/kung/chip/record.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::kung {

struct AfcStep {
  std::optional<std::int64_t> product;  // of the step's two factors, as the multiplier keeps it
  std::optional<std::int64_t> result;   // what the step hands to later ones
};

using AfcSteps = std::array<AfcStep, 35>;

AfcSteps afc_steps(const sw::AxisSetup& setup, const AfcStart& start);

}  // namespace trammel::kung
