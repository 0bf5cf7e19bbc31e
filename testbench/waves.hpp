// SPDX-License-Identifier: Apache-2.0
//
// Signal traces of a run: what the user asks for, what may be asked for, and what is made of the
// chip's FST file at the end.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "cosim/kung/types.hpp"

namespace trammel::testbench {

struct WaveArguments {  // as on the command line; empty = not given
  std::string format;
  std::string window;
  std::string trigger;
  std::string pre;
  std::string every;
};

// "a:b" with an optional s, ms, us or ns behind each: seconds. Throws ConfigError.
std::pair<double, double> parse_window(const std::string& text);

// Sets the keys run.wave_*. Throws ConfigError.
void apply_waves(kung::Options& options, const WaveArguments& arguments);

// Rules that concern more than one of these keys. Throws ConfigError.
void check_waves(const kung::Options& options);

// Before the run: a missing tool ends it (ToolMissing), many bytes are announced.
void announce_waves(const kung::Options& options);

// After the run: makes the VCD if that was asked for, and a view for GTKWave that will stand in
// `folder`. Returns 0, or 1 with a line on stderr when the waves asked for are not there.
int finish_waves(const kung::Options& options, const kung::Result& result,
                 const std::filesystem::path& folder);

// One paragraph for the report, empty without waves: files, windows, the trigger's time.
std::string waves_report(const kung::Options& options, const kung::Result& result,
                         const std::string& folder);

// The same for metrics.json; null without waves.
nlohmann::ordered_json waves_json(const kung::Options& options, const kung::Result& result);

// Writes vcd and removes fst; false when fst2vcd fails, and then fst stays.
bool fst_to_vcd(const std::filesystem::path& fst, const std::filesystem::path& vcd);

// The view `text` of waves/<machine>.gtkw, for one file: its path, the marker and the zoom.
std::string placed_view(const std::string& text, const std::filesystem::path& waves,
                        const kung::Result& result);

}  // namespace trammel::testbench
