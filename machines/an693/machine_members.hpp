// SPDX-License-Identifier: Apache-2.0
//
// Members of the description in machine.cpp that are in units of their own.
#pragma once

#include <string>
#include <vector>

#include "lab/machine.hpp"
#include "machines/an693/options.hpp"
#include "machines/an693/record.hpp"

namespace trammel::an693 {

const std::vector<lab::Key>& keys();    // keys.cpp
const lab::ColumnTable& columns();      // figures.cpp, as all that follow
std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& result);
void add_metrics(const lab::Record& record, nlohmann::ordered_json& json);
std::vector<std::string> remarks(const lab::Record& record);
double shaft_counts(const Options& options, double theta);  // of the true angle [rad]

// Of a program that ended: why its shaft is not at the target, "" if it is; of the step generator
// that of the first step which missed. The target is what the
// program asks for; run.reached_counts is what the true shaft may be off, and may still move in the
// last half of the time for which it was to stand there.
std::string what_missed(const Options& options, const Result& result);

const cosim::TriggerForms& triggers();  // machine.cpp

inline const Options& options_of(const lab::Record& record) {
  return static_cast<const Options&>(*record.settings);
}
inline const Result& result_of(const lab::Record& record) {
  return static_cast<const Result&>(*record.result);
}

}  // namespace trammel::an693
