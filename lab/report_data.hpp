// SPDX-License-Identifier: Apache-2.0
//
// What a report page is made of: the files of a finished run's folder, read back and checked, so
// that a page made at the end of a run and one made from its folder later are the same.
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "host/disk_vector.hpp"
#include "lab/machine.hpp"

namespace trammel::lab {

using Json = nlohmann::ordered_json;
using Series = host::DiskVector<double>;  // as long as the run, so kept where the run is

struct RunFolder {
  std::filesystem::path folder;
  const Machine* machine = nullptr;
  Json metrics;                           // metrics.json
  Json detail;                            // detail.json, or null
  std::map<std::string, Series> columns;  // of trace.csv, and those derived from them
  std::size_t first = 0;                  // row at which the path begins
  std::size_t rows = 0;
};

[[noreturn]] void corrupt(const std::filesystem::path& file, const std::string& what);

// The member that `path` names must be there and of that type.
void require_member(const std::filesystem::path& file, const Json& json, const std::string& path,
                    bool (Json::*is)() const noexcept);

// An array of `size` entries (0: any number) that all are what `each` says.
template <class Each>
bool is_list(const Json& json, std::size_t size, Each each) {
  return json.is_array() && (size == 0 || json.size() == size) &&
         std::all_of(json.begin(), json.end(), each);
}

// Throws ConfigError with one line that names the file and what is wrong with it.
RunFolder read_run(const std::filesystem::path& folder);

// Reads another table of the folder, with a row for each of the trace, into run.columns.
void read_table(const std::string& name, const std::vector<Column>& columns, RunFolder& run);

// The series a page holds. The data of each are whole steps of its resolution `lsb`, each less the
// one before it, as JSON in zlib's format in base64; lab/page/main.js unpacks them.
struct PageSeries {
  Json channels = Json::array();  // [{name, unit, help, lsb, data}]
  std::size_t count = 0;   // values a channel
  std::size_t stride = 1;  // samples from one value to the next
};

// At most `most` values a channel; of those columns alone that a page of several runs compares,
// where `compared`.
PageSeries page_series(const RunFolder& run, bool compared, std::size_t most);

}  // namespace trammel::lab
