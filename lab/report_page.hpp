// SPDX-License-Identifier: Apache-2.0
//
// report.html: one self-contained page of a run, or one that compares runs. The parts of the page
// are the files of lab/page/ and third_party/uplot/, embedded at build time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trammel::lab {

// <folder>/report.html from the folder's own files. Throws ConfigError when they are not those of a
// run. The page replaces an older one only when it is complete.
void write_run_page(const std::filesystem::path& folder);

// A page that compares the runs of 2 to 8 folders, the first one being the reference. Throws
// ConfigError, also for runs of different machines.
void write_comparison_page(const std::vector<std::filesystem::path>& folders,
                           const std::filesystem::path& file);

// The folder of the run in `base` that was written last. Throws ConfigError when there is none.
std::filesystem::path latest_run(const std::filesystem::path& base);

// Throws ConfigError where a page cannot be written as that file.
void check_page_target(const std::filesystem::path& file);

// The page of one folder, or of several, as that file.
void write_page(const std::vector<std::filesystem::path>& folders,
                const std::filesystem::path& file);

}  // namespace trammel::lab
