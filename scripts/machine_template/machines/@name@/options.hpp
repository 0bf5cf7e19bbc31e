// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine @name@ takes.
#pragma once

#include "lab/settings.hpp"
#include "models/plant/motor_axis.hpp"
#include "sw_nios/apps/@name@/@name@.hpp"

namespace trammel::@name@ {

const lab::Machine& machine();

struct Options final : lab::SettingsOf<Options, machine> {
  Options() { scenario = "@name@-step"; }

  sw::@Name@Setup controller;  // but for its last two, which follow from the rest
  double duration_s = 0.5;
  plant::MotorAxisConfig plant;
};

}  // namespace trammel::@name@
