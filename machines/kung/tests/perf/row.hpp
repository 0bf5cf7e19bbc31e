// SPDX-License-Identifier: Apache-2.0
//
// What the programs of the rows share: PROGRAM ROW KEY=VALUE... runs the circle with these keys and
// prints one JSON object. Time is that of the simulation alone, without start-up of the program.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "machines/kung/chip/record.hpp"

namespace trammel::perf {

struct Outcome {
  cosim::Clk clocks = 0;
  cosim::Clk evaluated = 0;
  std::uint64_t event_hash = 0;
  std::size_t samples = 0;  // kept for the record
};

struct Arguments {
  std::string row;
  std::string pins;      // pins=FILE: where the pins of every clock go; "" = nowhere
  double speed_m_s = 0;  // speed=V, of the row `speed`
  kung::Options options;
};

// Runs and prints; the exit code: 0, or 2 for arguments that cannot run.
int report(int argc, char** argv, const std::function<Outcome(const Arguments&)>& run);

}  // namespace trammel::perf
