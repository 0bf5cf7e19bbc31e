// SPDX-License-Identifier: Apache-2.0
//
// What a run of the machine mcafee gives.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "host/disk_vector.hpp"
#include "machines/mcafee/chip.hpp"
#include "machines/mcafee/options.hpp"

namespace trammel::mcafee {

class StagePlant;

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

// Of chip and plant, without the program's words.
Sample sample_of(cosim::Clk edge, const McafeeChip& chip, const StagePlant& plant);

// What happened to one axis.
struct Event {
  std::size_t sample = 0;  // of the record
  double time_s = 0;       // from the start of the run
  int axis = 0;
  std::string what;          // "interrupt", "motor off", "low switch open"...
  std::int64_t desired = 0;  // [count]
  std::int64_t real = 0;
  unsigned status = 0;
};

struct Result : cosim::RunResult {
  std::size_t sample_count() const override { return samples.size(); }
  std::string fault_text() const override { return fault; }

  host::DiskVector<Sample> samples;  // from the first after the reset routine on
  std::string fault;            // kFault: what the program saw; kMissed: what was missed
  std::uint32_t readings = 0;   // of Stage I
  std::array<std::int32_t, 2> real{};  // RDRP at the end [count]
  Table table;                  // that the program followed

  host::DiskVector<double> contour_mm;  // distance from the path in every sample, of Stage III

  // What evaluate() found: with the first sample the motion begins.
  std::size_t first = 0;
  std::vector<Event> events;
};

}  // namespace trammel::mcafee
