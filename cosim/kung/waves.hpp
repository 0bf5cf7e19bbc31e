// SPDX-License-Identifier: Apache-2.0
//
// What a window of waves hangs at: a trigger, or the drives' start, since the gates are off before.
#pragma once

#include "cosim/kung/trigger.hpp"
#include "cosim/wave_plan.hpp"

namespace trammel::kung {

inline constexpr char kWaveStart[] = "drives";

using Waves = cosim::Waves<TriggerSearch>;

}  // namespace trammel::kung
