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
#include "cosim/lm628/types.hpp"
#include "cosim/mcafee/types.hpp"

namespace trammel::testbench {

struct WaveArguments {  // as on the command line; empty = not given
  std::string format;
  std::string window;
  std::string trigger;
  std::string pre;
  std::string every;
};

// What waves of a machine's chip are.
struct WaveMachine {
  const char* view;   // in waves/
  const char* start;  // trigger of the default window
  void (*check_trigger)(const std::string& text, const std::string& where);  // throws ConfigError
  double vcd_bytes_s;  // of a trace, its order of magnitude, to warn before it fills a disk
  double fst_bytes_s;
};
template <class Options>
const WaveMachine& wave_machine();
template <>
const WaveMachine& wave_machine<kung::Options>();
template <>
const WaveMachine& wave_machine<lm628::Options>();
template <>
const WaveMachine& wave_machine<mcafee::Options>();

// What a run asks for.
struct WaveRequest {
  template <class Options>
  WaveRequest(const Options& options)  // NOLINT: any machine's options are one
      : run(options.run), machine(wave_machine<Options>()) {}

  const cosim::RunBasics& run;
  const WaveMachine& machine;
};

// "a:b" with an optional s, ms, us or ns behind each: seconds. Throws ConfigError.
std::pair<double, double> parse_window(const std::string& text);

// Sets the keys run.wave_*. Throws ConfigError.
template <class Options>
void apply_waves(Options& options, const WaveArguments& arguments);

// Rules that concern more than one of these keys. Throws ConfigError.
void check_waves(const WaveRequest& waves);

// Before the run: a missing tool ends it (ToolMissing), many bytes are announced.
void announce_waves(const WaveRequest& waves);

// Where the chip writes them, in the folder of a run.
inline std::string wave_file(const std::filesystem::path& folder) {
  return (folder / "waves.fst").string();
}

// After the run: makes the VCD if that was asked for, and a view for GTKWave that will stand in
// `folder`. Returns 0, or 1 with a line on stderr when the waves asked for are not there.
int finish_waves(const WaveRequest& waves, const cosim::RunResult& result,
                 const std::filesystem::path& folder);

// One paragraph for the report, empty without waves: files, windows, the trigger's time.
std::string waves_report(const WaveRequest& waves, const cosim::RunResult& result,
                         const std::string& folder);

// The same for metrics.json, of a run with waves.
nlohmann::ordered_json waves_json(const WaveRequest& waves, const cosim::RunResult& result);

// Writes vcd and removes fst; false when fst2vcd fails, and then fst stays.
bool fst_to_vcd(const std::filesystem::path& fst, const std::filesystem::path& vcd);

// The view `text` of waves/<machine>.gtkw, for one file: its path, the marker and the zoom.
std::string placed_view(const std::string& text, const std::filesystem::path& waves,
                        const cosim::RunResult& result);

}  // namespace trammel::testbench
