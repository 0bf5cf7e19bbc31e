// SPDX-License-Identifier: Apache-2.0
//
// One run, one directory. Files are written into a hidden folder beside it and moved in at the end,
// so that a run that fails leaves nothing half written and an older result stays whole until then.
#pragma once

#include <fmt/os.h>

#include <filesystem>
#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "testbench/keys.hpp"
#include "testbench/metrics.hpp"

namespace trammel::testbench {

class OutputFolder {
 public:
  // Throws ConfigError when the folder cannot be written: before the run, not after it.
  explicit OutputFolder(const std::filesystem::path& target);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& scratch() const { return scratch_; }
  const std::filesystem::path& target() const { return target_; }

  // Moves the files in. Files of an earlier run that this one did not write are removed; what
  // trammel did not write is left alone.
  void publish();

 private:
  std::filesystem::path target_;
  std::filesystem::path scratch_;
};

// Where a run goes: `out` as it was asked for, or the scenario's own folder.
std::filesystem::path target_of(const std::string& out, const std::string& scenario);

// A line on stderr for a run that did not end as it should; the exit code.
int tell_end(const std::string& scenario, kung::EndReason end, const std::string& cause,
             const std::string& folder);

// metrics.json: figures, comparison, versions, options.
nlohmann::ordered_json metrics_json(const kung::Options& options, const kung::Result& result,
                                    const Metrics& metrics);

nlohmann::ordered_json versions_json();
nlohmann::ordered_json value_json(const Value& value);

void write_text(const std::filesystem::path& file, const std::string& text);

// A file as long as the run, printed as it goes; throws ConfigError when it cannot be written.
void write_lines(const std::filesystem::path& file,
                 const std::function<void(fmt::ostream&)>& print);
void write_trace(const std::filesystem::path& file, const kung::Options& options,
                 const kung::Result& result);

// path.svg and error.svg through gnuplot; false when gnuplot is missing or fails.
bool write_pictures(const std::filesystem::path& folder, const kung::Options& options,
                    const kung::Result& result);

// How our pictures look: a gnuplot terminal of width and height.
inline constexpr char kPictureStyle[] =
    "set terminal svg size {},{} dynamic enhanced font 'Helvetica,13' background '#ffffff'\n"
    "set grid lc rgb '#dddddd' lt 1\n"
    "set border lc rgb '#666666'\n"
    "set key outside top center horizontal samplen 2\n";

// Runs a script of gnuplot that writes `first`; false when gnuplot is missing or fails.
bool draw(const std::filesystem::path& folder, const std::string& script,
          const std::string& first);

// What of a name gnuplot takes as text: a quote or mark-up in it is left out.
std::string plain_text(const std::string& name);

// First program of that name in PATH, or empty.
std::filesystem::path find_program(const std::string& name);

// A word of the shell, whatever it holds.
std::string shell_word(const std::filesystem::path& path);

const char* fault_text(kung::FaultCode code);
std::string cause_text(const kung::Fault& fault);  // of a trip, with its axis
std::string promise_text(const cosim::BrokenPromise& promise, std::int64_t clock_ps);
nlohmann::ordered_json promise_json(const cosim::BrokenPromise& promise);

// What stands behind the end of a run: the promise that broke, or the fault.
template <class Result>
std::string end_cause(const Result& result, std::int64_t clock_ps) {
  if (result.promise) return ": " + promise_text(*result.promise, clock_ps);
  return result.fault.empty() ? "" : " by " + result.fault;
}

const char* end_text(kung::EndReason end);
int exit_code(kung::EndReason end);

}  // namespace trammel::testbench
