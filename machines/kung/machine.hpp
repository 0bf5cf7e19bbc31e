// SPDX-License-Identifier: Apache-2.0
//
// The parts of machine.cpp that stand in units of their own.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cosim/session.hpp"
#include "lab/machine.hpp"
#include "machines/kung/options.hpp"
#include "machines/kung/record.hpp"

namespace trammel::kung {

const std::vector<lab::Key>& keys();                              // keys.cpp
void validate(lab::Settings& settings);                           // plan.cpp
std::vector<std::string> advice(const lab::Settings& settings);    // advice.cpp
const cosim::TriggerForms& triggers();                            // trigger.cpp
const lab::ColumnTable& columns();                                // columns.cpp
std::vector<lab::Figure> figures(const lab::Settings& settings,   // figures_list.cpp
                                 cosim::RunResult& result);
std::string verdict(const lab::Settings& settings, const cosim::RunResult& result);
std::vector<std::string> remarks(const lab::Record& record);
void check_cpu(const Options& options);                           // cpu.cpp
std::vector<std::string> cpu_lines(const Options& options, const Result& result);
void add_cpu(const Options& options, const Result& result, nlohmann::ordered_json& json);
void add_metrics(const lab::Record& record, nlohmann::ordered_json& json);
nlohmann::ordered_json detail_json(const Options& options, const Result& result);  // page.cpp
lab::Page page();
std::string experiments_text(const std::vector<const lab::Record*>& records);

inline const Options& options_of(const lab::Record& record) {
  return static_cast<const Options&>(*record.settings);
}
inline const Result& result_of(const lab::Record& record) {
  return static_cast<const Result&>(*record.result);
}

}  // namespace trammel::kung
