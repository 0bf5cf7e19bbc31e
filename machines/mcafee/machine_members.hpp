// SPDX-License-Identifier: Apache-2.0
//
// Members of the description in machine.cpp that are in units of their own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/machine.hpp"
#include "machines/mcafee/options.hpp"
#include "machines/mcafee/record.hpp"

namespace trammel::mcafee {

const std::vector<lab::Key>& keys();    // keys.cpp
const lab::ColumnTable& columns();      // figures.cpp, as the next three
std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& result);
void add_metrics(const lab::Record& record, nlohmann::ordered_json& json);

// outcome.cpp: finds the distance of the true table from its path in every sample, if it tracks.
void find_contour(const Options& options, Result& result);

// Of a program that ended: why the true table did not do what was asked, "" if it did. It keeps
// beside its path and comes to rest at the end of it, or of its move, within run.reached_counts.
std::string what_missed(const Options& options, const Result& result);

// Why a program gave up, "" if it did not.
const char* what_failed(const sw::Mailbox& mailbox);

// rules.cpp: the table of a path. Throws host::ConfigError for one that cannot be followed.
Table table_of(const Options& options);
void validate(lab::Settings& settings);
std::vector<std::string> warnings(const lab::Settings& settings);

// comparison.cpp: the same path at constant speeds.
std::vector<lab::Companion> companions(const lab::Settings& settings);
std::string run_name(const lab::Settings& settings);

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
