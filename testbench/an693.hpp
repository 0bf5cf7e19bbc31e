// SPDX-License-Identifier: Apache-2.0
//
// A run of the machine an693: its figures, its files, and what a person reads of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "testbench/config.hpp"
#include "testbench/run.hpp"

namespace trammel::testbench {

// Samples are counted from the first in which the desired position moves, that being 1.
struct An693Metrics {
  struct Interrupt {
    std::int64_t sample = 0;   // 0: before the motion
    double time_s = 0;         // from the start of the run
    std::int64_t desired = 0;  // [count]
    std::int64_t real = 0;
    unsigned status = 0;       // of that sample, which says why
  };

  std::vector<Interrupt> interrupts;  // at which HI rose
  std::int64_t moving_samples = 0;    // until the desired position stood for good
  double moving_s = 0;
  std::int64_t max_error_counts = 0;
  double overshoot_counts = 0;        // beyond the desired position, in the direction of motion
  double settled_s = 0;               // from the first motion until within 2.5 counts, for good or
                                      // until the next
  double max_speed_rev_s = 0;
  double max_voltage_V = 0;
  double max_current_A = 0;
};

An693Metrics evaluate(const lm628::Options& options, const lm628::Result& result);

// What a script does itself, or what does not end its run.
bool of_firmware(const KeyInfo& key);

double seconds_at(const lm628::Options& options, cosim::Clk edge);
double shaft_counts(const lm628::Options& options, const lm628::Sample& sample);  // the true angle

// motion.svg: trajectory, terms of the filter, and status over time; false without gnuplot.
bool write_motion_picture(const std::filesystem::path& folder, const lm628::Options& options,
                          const lm628::Result& result);

// A run that a script drove, not the firmware: the keys of the firmware are none of it.
struct An693Script {
  std::string text;                 // script.lm628
  nlohmann::ordered_json answers;   // an entry a line
};

// metrics.json; `command` repeats the run.
nlohmann::ordered_json an693_json(const lm628::Options& options, const lm628::Result& result,
                                  const An693Metrics& metrics, const std::string& command,
                                  const An693Script* script);

// All files of a run, and one line on stderr for each that cannot be made. True with report.html.
bool write_an693_files(const std::filesystem::path& folder, const lm628::Options& options,
                       const lm628::Result& result, const nlohmann::ordered_json& metrics,
                       const An693Script* script, bool report);

// What a person reads at the end; `page` is report.html, or empty.
std::string an693_report(const lm628::Options& options, const lm628::Result& result,
                         const An693Metrics& metrics, const std::string& folder,
                         const std::string& page);

// Simulates, writes the output folder and prints the figures; the exit code.
int run_an693(lm628::Options options, const RunArguments& arguments,
              const SimulateAn693& simulate, const std::atomic<bool>& stop);

}  // namespace trammel::testbench
