// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine @name@ gives.
#pragma once

#include <cstdint>
#include <string>

#include "cosim/run.hpp"
#include "host/disk_vector.hpp"
#include "machines/@name@/options.hpp"

namespace trammel::@name@ {

struct Sample {
  cosim::Clk edge = 0;
  std::int32_t count = 0;  // of the chip
  std::int32_t duty = 0;   // at its pins
  double theta = 0;        // [rad]
  double omega = 0;        // [rad/s]
  double i = 0;            // [A]
};

struct Result : cosim::RunResult {
  std::size_t sample_count() const override { return samples.size(); }
  std::string fault_text() const override { return fault; }

  host::DiskVector<Sample> samples;
  std::string fault;
};

// The speed that is asked for [rev/s]: the firmware looks once a millisecond.
inline double wanted_rev_s(const Options& options) {
  return options.controller.speed * 1000.0 / options.plant.counts;
}

inline double rev_s(const Sample& sample) { return sample.omega / plant::MotorAxis::kTurn; }

}  // namespace trammel::@name@
