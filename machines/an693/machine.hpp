// SPDX-License-Identifier: Apache-2.0
//
// The parts of machine.cpp that stand in units of their own.
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

const cosim::TriggerForms& triggers();  // machine.cpp

inline const Options& options_of(const lab::Record& record) {
  return static_cast<const Options&>(*record.settings);
}
inline const Result& result_of(const lab::Record& record) {
  return static_cast<const Result&>(*record.result);
}

}  // namespace trammel::an693
