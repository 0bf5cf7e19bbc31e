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

struct RunRecord;

// What the files of a machine's runs must hold, and how fine a page shows them.
struct PageOf {
  std::vector<std::string> texts, counts, numbers, objects, arrays;  // members of metrics.json
  std::vector<std::string> columns;                          // of trace.csv
  std::vector<std::string> compared;                         // series of a page of several runs
  std::vector<std::string> flags;                            // columns of bits: none is passed over
  bool (*has_detail)(const Json& metrics) = nullptr;         // detail.json is there
  void (*check_detail)(const std::filesystem::path& file, const Json& detail) = nullptr;
  void (*complete)(RunRecord& run) = nullptr;                // first row, series made of others
  double (*lsb)(const std::string& column) = nullptr;        // of a series
  Json (*keys)() = nullptr;                                  // default and meaning of each key
  std::string (*title)(const Json& metrics) = nullptr;
};

// Throws ConfigError, which names the file, for a machine that has no page.
const PageOf& page_of(const Json& machine, const std::filesystem::path& file);

struct RunRecord {
  std::filesystem::path folder;
  const PageOf* page = nullptr;                        // of its machine
  Json metrics;                                        // metrics.json
  Json detail;                                         // detail.json, or null
  std::map<std::string, Series> columns;               // of trace.csv
  std::size_t first = 0;                               // row at which the path begins
  std::size_t rows = 0;
};

[[noreturn]] void corrupt(const std::filesystem::path& file, const std::string& what);

// The member that `path` names must be there and of that type.
void require_member(const std::filesystem::path& file, const Json& json, const std::string& path,
                    bool (Json::*is)() const noexcept);

// Throws ConfigError with one line that names the file and what is wrong with it.
RunRecord read_run(const std::filesystem::path& folder);

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
