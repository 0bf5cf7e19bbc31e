// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine larson takes: the interface, a stepper with its pulse buffer on each
// axis, and a script of calls.
#pragma once

#include "lab/settings.hpp"
#include "machines/larson/script.hpp"
#include "models/plant/stepper_axis.hpp"
#include "sw_nios/apps/larson/larson.hpp"

namespace trammel::larson {

const lab::Machine& machine();

struct Result;  // record.hpp

struct Options final : lab::SettingsOf<Options, machine> {
  using Result = larson::Result;

  Options() { scenario = "larson-calibrate"; }

  std::string script = "calibrate";  // built-in name or a path; .csv: moves
  PlotSetup plot;               // but for soft_end, which is the table's
  double record_ms = 1;         // from one sample of the record to the next
  double settle_s = 0.25;       // recorded behind the last call
  int reached_steps = 2;        // most distance of the table from where its program has it
  sw::StepTableSetup table;     // but for poll_clk and settle_clk, which follow
  double poll_ms = 2;
  double wttbl_ms = 25;         // settle_clk: more than buffer.idle_s
  plant::StepperAxisConfig axis;  // both, but for where they start and its input
  double width_us = 1, setup_us = 1, hold_us = 1;  // axis.input
  double perpendicularity_arcsec = 0;  // of the Y axis, toward positive X
  double start_x = 400, start_y = 250;  // [step]
};

// Which faults this machine can have, and where.
cosim::FaultPins fault_pins(const Options& options);

}  // namespace trammel::larson
