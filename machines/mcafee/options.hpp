// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine mcafee takes: two LM628 behind a port, a leadscrew stage, one of
// McAfee's programs.
#pragma once

#include "lab/settings.hpp"
#include "machines/mcafee/path.hpp"
#include "parts/lm628/options.hpp"
#include "models/plant/xy_stage.hpp"
#include "sw_nios/apps/mcafee/mcafee.hpp"

namespace trammel::mcafee {

const lab::Machine& machine();

struct Result;  // record.hpp

struct Options final : lab::SettingsOf<Options, machine> {
  using Result = mcafee::Result;

  Options() { scenario = "mcafee-stage3"; }

  sw::McafeeStage stage = sw::McafeeStage::kTrack;
  PathOptions path;
  int clock_MHz = 6;            // of the parts, 6 or 8
  sw::Lm628Filter filter{255, 0, 3000, 0, 1};
  int acceleration = 60000;     // as the parts take them: [2^-16 count/sample^2],
  int velocity = 0x2BB0D;       // [2^-16 count/sample], of Stage II
  int position = 0xCE40;        // [count], of Stage II
  int readings = 100;           // of Stage I
  int speed = 0;                // 1..255: constant; 0: the feed rate's
  int least_speed = 40;
  int velocity_shift = 2;
  double wait_s = 0.5;          // between readings, and at the end
  bool compare = false;         // also at constant speeds, 254 and the least one
  int error_limit = 0;          // [count] position error at which a part turns its motor off;
                                // 0: none
  bool index_check = false;     // the program checks that indexes are a turn apart
  int diverged_counts = 4000;   // position error that ends the run as diverged
  int reached_counts = 0;       // largest error, and movement at the end, of a table that did what
                                // was asked; 0: by the path or travel
  plant::LeadscrewConfig stage_axis;  // both

  double sample_s() const { return lm628::sample_s(clock_MHz); }
  bool tracks() const { return stage == sw::McafeeStage::kTrack; }
  double count_mm() const { return 1e3 * stage_axis.pitch / (4 * stage_axis.encoder.lines); }
  TravelMm travel_mm() const {
    return {1e3 * stage_axis.switch_low, 1e3 * stage_axis.switch_high};
  }
};

// Which faults this machine can have, and where.
cosim::FaultPins fault_pins(const Options& options);

}  // namespace trammel::mcafee
