// SPDX-License-Identifier: Apache-2.0
//
// What one run of the machine mcafee takes and gives: two LM628 behind a port, a leadscrew stage,
// one of McAfee's programs.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cosim/disk_vector.hpp"
#include "cosim/machine.hpp"
#include "cosim/mcafee/chip.hpp"
#include "cosim/mcafee/table.hpp"
#include "models/plant/xy_stage.hpp"
#include "sw_nios/apps/mcafee.hpp"

namespace trammel::mcafee {

inline constexpr double kSampleS = 2048 / 6e6;

using cosim::Engine;

struct RunOptions : cosim::RunBasics {
  int diverged_counts = 4000;   // position error that ends the run as diverged
};

struct Options {
  std::string scenario = "mcafee-stage3";  // names the run and its output folder
  std::string description;
  sw::McafeeStage stage = sw::McafeeStage::kTrack;
  PathOptions path;
  sw::Lm628Filter filter{255, 0, 3000, 0, 1};
  int acceleration = 60000;  // as the parts take them: [2^-16 count/sample^2],
  int velocity = 0x2BB0D;    // [2^-16 count/sample], of Stage II
  int position = 0xCE40;     // [count], of Stage II
  int readings = 100;        // of Stage I
  int speed = 0;             // 1..255: constant; 0: the feed rate's
  int least_speed = 40;
  int velocity_shift = 2;
  double wait_s = 0.5;       // between readings, and at the end
  bool compare = false;      // also at constant speeds, 254 and the least one
  plant::LeadscrewConfig stage_axis;  // both
  cosim::ProcessorOptions processor;
  RunOptions run;

  double count_mm() const { return 1e3 * stage_axis.pitch / (4 * stage_axis.encoder.lines); }
  TravelMm travel_mm() const {
    return {1e3 * stage_axis.switch_low, 1e3 * stage_axis.switch_high};
  }
};

struct AxisSample {
  lm628::Words words;
  bool host_irq = false;
  double x_mm = 0;    // where the table is, from its start
  double mm_s = 0;    // its speed
  double i = 0;       // [A]
  double volt = 0;    // [V] that the amplifier is told to give
};

// At the edge that publishes a sample's results.
struct Sample {
  cosim::Clk edge = 0;
  std::array<AxisSample, 2> axis;
  unsigned limits = 0;   // X low, X high, Y low, Y high
  std::uint32_t row = 0;  // rows begun
  unsigned v = 0;         // speed of the last of them, 0..255
};

struct Result : cosim::RunResult {
  cosim::DiskVector<Sample> samples;  // from the first after the reset routine on
  std::string fault;            // kFault: what the program saw
  std::uint32_t readings = 0;   // of Stage I
  std::array<std::int32_t, 2> real{};  // RDRP at the end [count]
  Table table;                  // that the program followed
};

}  // namespace trammel::mcafee
