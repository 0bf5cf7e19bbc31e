// SPDX-License-Identifier: Apache-2.0
//
// Members of the description in machine.cpp that are in units of their own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lab/machine.hpp"
#include "machines/larson/options.hpp"
#include "machines/larson/record.hpp"

namespace trammel::larson {

const std::vector<lab::Key>& keys();    // keys.cpp
const lab::ColumnTable& columns();      // figures.cpp, as what follows
std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& result);
void add_metrics(const lab::Record& record, nlohmann::ordered_json& json);
std::vector<std::string> remarks(const lab::Record& record);

// published_values.cpp: Larson's own figures, beside those of the run and of its buffer.
std::vector<lab::Figure> published_figures(const Options& options, const Result& result);

// outcome.cpp: of a program that ended, why the table is not where its program has it; "" if it is.
std::string what_missed(const Options& options, const Result& result);

// And where a run that was cut was: "my.table:3: WTTBL was running".
std::string what_was_running(const Options& options, const Result& result);

// What a pulse that made no step breached: "direction turned 0.24 us behind its edge".
std::string breach_text(const plant::StepBreach& breach, std::int64_t clock_ps);

// rules.cpp
void validate(lab::Settings& settings);

// Calls of the options' script. Throws host::ConfigError.
std::vector<Call> calls_of(const Options& options);

inline const Options& options_of(const lab::Record& record) {
  return static_cast<const Options&>(*record.settings);
}
inline const Result& result_of(const lab::Record& record) {
  return static_cast<const Result&>(*record.result);
}

}  // namespace trammel::larson
