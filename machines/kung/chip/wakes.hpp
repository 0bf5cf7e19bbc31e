// SPDX-License-Identifier: Apache-2.0
//
// Why clocks of the chip are evaluated and not leapt over.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace trammel::kung {

// The first that holds.
enum class Wake {
  kLeap,       // stands for itself and the clocks leapt over
  kBus,        // a transfer is under way
  kTick,       // 2 kHz
  kConverter,  // serial frame of the current sensors
  kCurrent,    // current loop computes
  kPosition,   // position controller computes
  kEncoder,    // pins changed: synchronisers and filters settle
  kGate,       // a gate switches, its dead time ends, or the carrier begins anew
  kCount
};
inline constexpr std::size_t kWakes = static_cast<std::size_t>(Wake::kCount);
inline constexpr std::array<const char*, kWakes> kWakeNames{
    "leap", "bus",  "tick",    "converter", "current_loop", "position_controller",
    "encoder", "gate"};

using WakeCounts = std::array<std::int64_t, kWakes>;  // evaluated clocks

}  // namespace trammel::kung
