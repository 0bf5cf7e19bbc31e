// SPDX-License-Identifier: Apache-2.0
//
// The files of a run, of any machine.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "host/output_folder.hpp"
#include "lab/column.hpp"
#include "lab/record.hpp"

namespace trammel::lab {

// How a run describes itself that was not made by `trammel run SCENARIO`.
struct Origin {
  std::string command;                       // repeats it; "": a scenario and what differs from it
  bool (*left_out)(const Key&) = nullptr;    // keys that do not apply to it
  nlohmann::ordered_json more = nullptr;     // members of metrics.json
  std::map<std::string, std::string> files;  // name and content of further files
  std::filesystem::path folder = {};         // of its files, which a command may name
};

struct Written {
  bool page = false;               // report.html is there
  int code = 0;                    // exit code that tells of one that was asked for
  std::vector<std::string> notes;  // a line for each file that cannot be made
};

// metrics.json: how it ended, figures, speed, versions, settings.
nlohmann::ordered_json metrics_json(const Record& record, const Origin& origin = {});
nlohmann::ordered_json versions_json();
nlohmann::ordered_json value_json(const Value& value);

// trace.csv: a line a sample, from the machine's columns.
void write_trace(const std::filesystem::path& file, const Record& record);

// Another such table of `rows` lines: read() gives the values of one.
void write_table(const std::filesystem::path& file, const std::vector<Column>& columns,
                 std::size_t rows,
                 const std::function<void(std::size_t row, std::vector<double>& values)>& read);

// All files of a run, into the scratch of a folder that is to be published then. Throws ConfigError
// where one of those that hold the record cannot be written.
Written write_record(const Record& record, const host::OutputFolder& folder,
                     const nlohmann::ordered_json& metrics, const Origin& origin, bool page);

// What a person reads at the end of a run; `page`: report.html is there.
std::string report_text(const Record& record, const std::string& folder, bool page);
// What clock gating could save: lines of each clock domain of the chip.
std::string activity_text(const cosim::RunResult& result);

}  // namespace trammel::lab
