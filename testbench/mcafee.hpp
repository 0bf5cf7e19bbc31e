// SPDX-License-Identifier: Apache-2.0
//
// Runs of the machine mcafee and the tool that makes its paths: figures, files, and what a person
// reads of them.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cosim/mcafee/types.hpp"
#include "testbench/metrics.hpp"
#include "testbench/run.hpp"

namespace trammel::testbench {

// Of Stage III from the first row on, of the others from the first motion.
struct McafeeMetrics {
  struct Event {
    std::size_t sample = 0;  // of the record
    double time_s = 0;       // from the start of the run
    int axis = 0;
    std::string what;          // "interrupt", "motor off", "low switch open"...
    std::int64_t desired = 0;  // [count]
    std::int64_t real = 0;
    unsigned status = 0;
  };

  std::vector<Event> events;
  std::size_t first = 0;           // sample with which the motion begins
  double moving_s = 0;             // until the desired position stood for good
  double contour_max_mm = 0;       // distance of the table from the path: its largest,
  double contour_max_s = 0;        // when that was, from the first row on;
  double contour_rms_mm = 0;       // its root mean square while moving,
  double contour_end_mm = 0;       // and at the end
  Series contour_mm;               // in every sample, of Stage III
  std::int64_t max_error_counts = 0;  // of an axis
  double max_speed_mm_s = 0;          // of an axis: the table's,
  double max_desired_mm_s = 0;        // and that of the trajectory generator
  double max_current_A = 0;
};

McafeeMetrics evaluate(const mcafee::Options& options, const mcafee::Result& result);

// A run and its figures, in a picture beside others.
struct McafeeRun {
  std::string name;
  mcafee::Result result;
  McafeeMetrics metrics;
};

// path.svg, the path coloured by speed, and contour.svg, the contour errors of all runs over time;
// false without gnuplot.
bool write_tracking_pictures(const std::filesystem::path& folder, const mcafee::Options& options,
                             const std::vector<McafeeRun>& runs);

// detail.json of a run that tracks, for its page: rows of its table, contour errors of all runs.
nlohmann::ordered_json tracking_json(const mcafee::Options& options,
                                     const std::vector<McafeeRun>& runs);

// Simulates, writes the output folder and prints the figures; the exit code.
int run_mcafee(mcafee::Options options, const RunArguments& arguments,
               const SimulateMcafee& simulate, const std::atomic<bool>& stop);

// The verb `track`: the table of a path, as CSV to standard output or into `out`.
int track(const RunArguments& arguments);

}  // namespace trammel::testbench
