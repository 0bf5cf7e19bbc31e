// SPDX-License-Identifier: Apache-2.0
//
// report.html: one self-contained page of a run, or one that compares runs. The parts of the page
// are the files of lab/page/ and third_party/uplot/, embedded at build time.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace trammel::lab {

// The page of one folder of a run, or one that compares those of 2 to 12, the first being the
// reference. It replaces an older one only when it is complete. Throws ConfigError where a folder
// is not that of a run, runs are of different machines, or the file cannot be written.
void write_page(const std::vector<std::filesystem::path>& folders,
                const std::filesystem::path& file);

// Whether a file is a page that this wrote.
bool is_page(const std::filesystem::path& file);

// The folder of the run in `base` that was written last, no link. Throws ConfigError when there is
// none.
std::filesystem::path latest_run(const std::filesystem::path& base);

// The page without its data, for which @TITLE@ and @DATA@ stand; in a unit that embed_page.cmake
// writes.
extern const std::string_view kPage;

}  // namespace trammel::lab
