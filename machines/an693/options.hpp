// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine an693 takes: an LM628, a DC motor, a program of AN-693.
#pragma once

#include "lab/settings.hpp"
#include "models/plant/motor_axis.hpp"
#include "parts/lm628/options.hpp"
#include "sw_nios/apps/an693/an693.hpp"

namespace trammel::an693 {

const lab::Machine& machine();

struct Result;  // record.hpp

struct Options final : lab::SettingsOf<Options, machine> {
  using Result = an693::Result;

  Options() { scenario = "an693-absolute"; }

  sw::An693Program program = sw::An693Program::kAbsolute;
  lm628::PartOptions part;
  sw::An693Filter filter;
  int acceleration = 2;          // as the part takes them: [2^-16 count/sample^2],
  int velocity = 0x346E;         // [2^-16 count/sample]
  int position = 8000;           // [count]
  int breakpoint = 80000;        // [count]
  int steps = 4;
  double wait_s = 0.1;           // before STT, between steps, and at the end
  int error_limit = 0;           // [count] position error at which the part turns the motor off;
                                 // 0: none
  bool index_check = false;      // the program checks that indexes are a turn apart
  int diverged_counts = 30000;   // position error that ends the run as diverged
  int reached_counts = 0;        // largest error and movement of a shaft that is at its target;
                                 // 0: 50, or a quarter of the travel and at least 3
  plant::MotorAxisConfig plant;

  double sample_s() const { return lm628::sample_s(part.clock_MHz); }
};

// Which faults this machine can have, and where.
cosim::FaultPins fault_pins(const Options& options);

}  // namespace trammel::an693
