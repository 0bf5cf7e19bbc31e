// SPDX-License-Identifier: Apache-2.0
//
// The parts of machine.cpp that stand in units of their own.
#pragma once

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
const cosim::TriggerForms& triggers();  // machine.cpp

// The table of a path. Throws lab::ConfigError for one that cannot be followed.
Table table_of(const Options& options);

// detail.json of a run that tracks, for its page: rows of its table, contour errors of all runs.
nlohmann::ordered_json tracking_json(const lab::Record& record);
lab::Page page();  // detail_json.cpp, as the one before

inline const Options& options_of(const lab::Record& record) {
  return static_cast<const Options&>(*record.settings);
}
inline const Result& result_of(const lab::Record& record) {
  return static_cast<const Result&>(*record.result);
}

// The run itself, and those it is compared with.
inline std::vector<const lab::Record*> runs_of(const lab::Record& record) {
  std::vector<const lab::Record*> all{&record};
  for (const lab::Record& beside : record.companions) all.push_back(&beside);
  return all;
}

// One run. Throws cosim::OptionsError for a path that cannot be followed.
Result simulate(const Options& options, const cosim::Hooks& hooks = {});

}  // namespace trammel::mcafee
