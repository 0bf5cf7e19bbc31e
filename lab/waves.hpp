// SPDX-License-Identifier: Apache-2.0
//
// Signal traces of a run: what the user asks for, what may be asked for, and what is made of the
// chip's FST file at the end.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/record.hpp"

namespace trammel::lab {

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
void apply_waves(Settings& settings, const WaveArguments& arguments);

// Refuses a trigger that the machine does not know; `where` begins the message. Throws ConfigError.
void check_trigger(const Settings& settings, const std::string& text, const std::string& where);

// Rules that concern more than one of these keys. Throws ConfigError.
void check_waves(const Settings& settings);

// Before the run: a missing tool ends it (ToolMissing); what is to be said of their size.
std::optional<std::string> waves_notice(const Settings& settings);

// Where the chip writes them, in the folder of a run.
inline std::string wave_file(const std::filesystem::path& folder) {
  return (folder / "waves.fst").string();
}

// After the run: makes the VCD if that was asked for, and views for GTKWave and Surfer, of files
// that will stand in `folder`. False when the waves asked for are not there; `notes` says why, and
// what else is amiss.
bool finish_waves(const Settings& settings, const cosim::RunResult& result,
                  const std::filesystem::path& folder, std::vector<std::string>& notes);

// One paragraph for the report, empty without waves: files, windows, the trigger's time.
std::string waves_text(const Settings& settings, const cosim::RunResult& result,
                       const std::string& folder);

// The same for metrics.json, of a run with waves.
nlohmann::ordered_json waves_json(const Settings& settings, const cosim::RunResult& result);

// Writes vcd and removes fst; false when fst2vcd fails, and then fst stays.
bool fst_to_vcd(const std::filesystem::path& fst, const std::filesystem::path& vcd);

// The view `text` of a machine, for one file: its path, the marker and the zoom.
std::string placed_view(const std::string& text, const std::filesystem::path& waves,
                        const cosim::RunResult& result);

// The commands `text` for Surfer, and those that show the first window and the trigger.
std::string placed_commands(const std::string& text, const cosim::RunResult& result);

}  // namespace trammel::lab
