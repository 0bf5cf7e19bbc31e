// SPDX-License-Identifier: Apache-2.0
//
// The parts of machine.cpp that stand in units of their own.
#pragma once

#include <filesystem>
#include <vector>

#include "lab/machine.hpp"
#include "machines/mcafee/options.hpp"
#include "machines/mcafee/record.hpp"

namespace trammel::mcafee {

const std::vector<lab::Key>& keys();    // keys.cpp
const lab::ColumnTable& columns();      // figures.cpp, as the next three
std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& result);
void add_metrics(const lab::Record& record, nlohmann::ordered_json& json);
const cosim::TriggerForms& triggers();  // machine.cpp

// The table of a path. Throws lab::ConfigError for one that cannot be followed.
Table table_of(const Options& options);

// detail_json.cpp: detail.json of a run that tracks (else null), its tables, and its page.
nlohmann::ordered_json tracking_json(const lab::Record& record);
void write_tables(const lab::Record& record, const std::filesystem::path& folder);
lab::Page page();

inline const Options& options_of(const lab::Record& record) {
  return static_cast<const Options&>(*record.settings);
}
inline const Result& result_of(const lab::Record& record) {
  return static_cast<const Result&>(*record.result);
}

}  // namespace trammel::mcafee
