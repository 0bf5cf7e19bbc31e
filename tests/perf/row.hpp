// SPDX-License-Identifier: Apache-2.0
//
// What the programs of the rows share: PROGRAM ROW KEY=VALUE... runs the circle with these keys and
// prints one JSON object. Time is that of the simulation alone, without start-up of the program.
#pragma once

#include <sys/resource.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "cosim/kung/types.hpp"

namespace trammel::perf {

struct Outcome {
  cosim::Clk clocks = 0;
  cosim::Clk evaluated = 0;
  std::uint64_t event_hash = 0;
};

struct Arguments {
  std::string row;
  std::string pins;  // pins=FILE: where the pins of every clock go, "" = nowhere
  kung::Options options;
};

// The circle as `trammel run` sets it up; throws testbench::ConfigError.
Arguments read_arguments(int argc, char** argv);

inline double user_s() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return static_cast<double>(use.ru_utime.tv_sec) + 1e-6 * static_cast<double>(use.ru_utime.tv_usec);
}

// Runs and prints; the exit code: 0, or 2 for arguments that cannot run.
int report(int argc, char** argv, const std::function<Outcome(const Arguments&)>& run);

}  // namespace trammel::perf
