// SPDX-License-Identifier: Apache-2.0
//
// What a report page is made of: the files of a finished run's folder, read back and checked, so
// that a page made at the end of a run and one made from its folder later are the same.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "testbench/metrics.hpp"

namespace trammel::testbench {

using Json = nlohmann::ordered_json;

struct RunRecord {
  std::filesystem::path folder;
  Json metrics;                                        // metrics.json
  Json detail;                                         // detail.json
  std::map<std::string, Series> columns;               // of trace.csv
  std::size_t first = 0;                               // row at which the path begins
  std::size_t rows = 0;
};

// Throws ConfigError with one line that names the file and what is wrong with it.
RunRecord read_run(const std::filesystem::path& folder);

// Columns of trace.csv after tick and t_s, with x_ or y_ in front.
const std::vector<std::string>& axis_columns();

// detail.json: the steps of one sample, the gates of two PWM periods, the rules.
Json detail_json(const kung::Options& options, const kung::Result& result);

// The series a page holds, ready for it: names, scales and one block of coded integers.
struct PageSeries {
  Json channels;          // [{name, lsb, order}]
  std::string data;       // base64 of zlib of all of them, delta-coded
  std::size_t count = 0;  // values a channel
  std::size_t stride = 1; // samples from one value to the next
};

// At most `most` values a channel; `names` empty: all.
PageSeries page_series(const RunRecord& run, const std::vector<std::string>& names,
                       std::size_t most);

}  // namespace trammel::testbench
