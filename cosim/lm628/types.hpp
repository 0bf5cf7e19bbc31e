// SPDX-License-Identifier: Apache-2.0
//
// What one run of the machine an693 takes and gives: an LM628, a DC motor, a program of AN-693.
#pragma once

#include <cstdint>
#include <string>

#include "cosim/cosim.hpp"
#include "cosim/disk_vector.hpp"
#include "cosim/lm628/chip.hpp"
#include "cosim/machine.hpp"
#include "models/plant/motor_axis.hpp"
#include "sw_nios/apps/an693.hpp"

namespace trammel::lm628 {

inline constexpr double kSampleS = 256e-6;  // 2048 ticks of 8 MHz

struct RunOptions : cosim::RunBasics {
  int diverged_counts = 30000;  // position error that ends the run as diverged
};

struct Options {
  std::string scenario = "an693-absolute";  // names the run and its output folder
  std::string description;
  sw::An693Program program = sw::An693Program::kAbsolute;
  sw::An693Filter filter;
  int acceleration = 2;       // as the part takes them: [2^-16 count/sample^2],
  int velocity = 0x346E;      // [2^-16 count/sample]
  int position = 8000;        // [count]
  int breakpoint = 80000;     // [count]
  int steps = 4;
  double wait_s = 0.1;        // before STT, between steps, and at the end
  plant::MotorAxisConfig plant;
  cosim::ProcessorOptions processor;
  RunOptions run;
};

// At the edge that publishes a sample's results.
struct Sample {
  cosim::Clk edge = 0;
  Words words;
  bool host_irq = false;
  double theta = 0;  // [rad]
  double omega = 0;  // [rad/s]
  double i = 0;      // [A]
  double volt = 0;   // [V]
};

struct Result : cosim::RunResult {
  cosim::DiskVector<Sample> samples;      // from the first after the reset routine on
  std::string fault;                // kFault: what the program saw
  std::int32_t desired = 0;         // RDDP and RDRP at the end [count]
  std::int32_t real = 0;
};

}  // namespace trammel::lm628
