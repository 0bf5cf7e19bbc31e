// SPDX-License-Identifier: Apache-2.0
//
// Members of the description in machine.cpp that are in units of their own.
#pragma once

#include <string>
#include <vector>

#include "lab/machine.hpp"
#include "machines/gantry/options.hpp"
#include "machines/gantry/record.hpp"

namespace trammel::gantry {

const std::vector<lab::Key>& keys();  // keys.cpp
const lab::ColumnTable& columns();    // columns.cpp
std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& result);
void add_metrics(const lab::Record& record, nlohmann::ordered_json& json);
std::vector<std::string> remarks(const lab::Record& record);

// rules.cpp
void validate(lab::Settings& settings);
std::vector<std::string> warnings(const lab::Settings& settings);  // what no run of them sends

// missed.cpp: why the program gave up, and what chip and program have seen of a fault; why a run
// that came to its end is not done; each "" where it is not so.
const char* what_failed(const sw::GantryMailbox& mail);
std::string what_noticed(const sw::GantryMailbox& mail, const Words& words);
std::string what_missed(const Options& options, const Result& result);
std::string verdict(const lab::Settings& settings, const cosim::RunResult& run);

// What the non-volatile memory holds at power-on: data of an ideal sensor of amplitude 400.
Store ideal_store();  // store.cpp

inline const Options& options_of(const lab::Record& record) {
  return static_cast<const Options&>(*record.settings);
}
inline const Result& result_of(const lab::Record& record) {
  return static_cast<const Result&>(*record.result);
}

}  // namespace trammel::gantry
