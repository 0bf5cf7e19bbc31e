// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine an693 gives.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/disk_vector.hpp"
#include "machines/an693/options.hpp"
#include "parts/lm628/chip.hpp"

namespace trammel::an693 {

// At the edge that publishes a sample's results.
struct Sample {
  cosim::Clk edge = 0;
  lm628::Words words;
  bool host_irq = false;
  double theta = 0;  // [rad]
  double omega = 0;  // [rad/s]
  double i = 0;      // [A]
  double volt = 0;   // [V] from here on; of an H-bridge the mean since the sample before
};

// Of the part: HI rose.
struct Interrupt {
  std::int64_t sample = 0;   // 0: before the motion
  double time_s = 0;         // from the start of the run
  std::int64_t desired = 0;  // [count]
  std::int64_t real = 0;
  unsigned status = 0;       // of that sample, which says why
};

struct Result : cosim::RunResult {
  std::size_t sample_count() const override { return samples.size(); }
  std::string fault_text() const override { return fault; }

  host::DiskVector<Sample> samples;  // from the first after the reset routine on
  std::string fault;                  // kFault: what the program saw; kMissed: what was missed
  std::int32_t desired = 0;           // RDDP and RDRP at the end [count]
  std::int32_t real = 0;
  std::vector<std::size_t> step_ends;  // of tuning: samples until the next step, or the end
  std::vector<Interrupt> interrupts;  // what evaluate() found
};

}  // namespace trammel::an693
