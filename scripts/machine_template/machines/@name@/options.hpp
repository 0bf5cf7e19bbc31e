// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine @name@ takes.
#pragma once

#include <algorithm>
#include <cstdint>

#include "lab/settings.hpp"
#include "models/plant/motor_axis.hpp"
#include "sw_nios/apps/@name@/@name@.hpp"

namespace trammel::@name@ {

inline constexpr double kInterruptS = 1e-3;

const lab::Machine& machine();

struct Options final : lab::SettingsOf<Options, machine> {
  Options() { scenario = "@name@-step"; }

  sw::@Name@Setup controller;  // but for its last two, which follow from the rest
  double duration_s = 0.5;
  plant::MotorAxisConfig plant;

  // The timer is written again two accesses after its interrupt is taken.
  sw::@Name@Setup firmware() const {
    sw::@Name@Setup setup = controller;
    setup.interrupts = static_cast<std::uint32_t>(duration_s / kInterruptS + 0.5);
    const cosim::Clk lost = processor.interrupt_latency_clk + 2 * (processor.access_clk + 1);
    setup.timer_clk = static_cast<std::uint32_t>(
        std::max<cosim::Clk>(1, run.clocks(kInterruptS) - lost));
    return setup;
  }
};

}  // namespace trammel::@name@
