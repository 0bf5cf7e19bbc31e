// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine gantry takes: the chip, two motors on a belt, stripes, and what the
// host sends.
#pragma once

#include <string>

#include "lab/settings.hpp"
#include "machines/gantry/estimator.hpp"
#include "machines/gantry/host.hpp"
#include "models/plant/belt_axis.hpp"
#include "models/plant/stripe_track.hpp"
#include "sw_nios/apps/gantry/gantry.hpp"

namespace trammel::gantry {

const lab::Machine& machine();

struct Result;  // record.hpp

struct Options final : lab::SettingsOf<Options, machine> {
  using Result = gantry::Result;

  Options() { scenario = "gantry-p"; }

  std::string sends = "0.1:21=305";  // what the host sends, and when; see host.hpp
  double time_s = 3;                 // of the experiment
  double reference_mm = 305;         // that overshoot and settling are measured from
  double from_mm = 0;                // where the step begins
  double zero_mm = 0;                // where on the track these are 0: its end is -2
  double band_mm = 1;                // arrived: within it
  double reached_mm = -1;            // most distance from the reference at the end; below 0: any
  double record_ms = 1;              // from one sample of the record to the next
  bool serial = false;               // a pseudo-terminal instead of `sends`, in real time
  double gap_ms = 10;                // of silence within a frame; 0: any
  LineConfig line;
  sw::GantrySetup firmware;          // but for pass_clk and gap_clk, which follow
  EstimatorConfig estimator;         // of the velocity
  double pass_ms = 2;
  double open_hold_ms = 20;          // of a force without controller
  plant::BeltAxisConfig axis;
  plant::StripeTrackConfig stripes;
};

// Which faults this machine can have, and where.
cosim::FaultPins fault_pins(const Options& options);

}  // namespace trammel::gantry
