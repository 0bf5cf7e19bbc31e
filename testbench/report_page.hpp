// SPDX-License-Identifier: Apache-2.0
//
// report.html: one self-contained page of a run, or one that compares runs. The parts of the page
// are the files of testbench/page/ and third_party/uplot/, embedded at build time.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace trammel::testbench {

// <folder>/report.html from the folder's own files. Throws ConfigError when they are not those of a
// run. The page replaces an older one only when it is complete.
void write_run_page(const std::filesystem::path& folder);

// Calls what writes a page at the end of a run, which is never lost because that failed: then one
// line says so.
bool guarded(const std::function<void()>& write);

// A page that compares the runs of 2 to 8 folders, the first one being the reference. Throws
// ConfigError, also for runs of different machines.
void write_comparison_page(const std::vector<std::filesystem::path>& folders,
                           const std::filesystem::path& file);

struct ReportArguments {
  std::vector<std::string> folders;  // none: the latest run in out/
  std::string out;                   // default: report.html in the folder, or out/compare.html
  bool json = false;
};

int report(const ReportArguments& arguments);  // the verb

// The command that repeats a run: a built-in scenario with what differs from it, or its run.toml.
template <class Options>
std::string repeat_command(const Options& options);

}  // namespace trammel::testbench
