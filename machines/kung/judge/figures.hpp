// SPDX-License-Identifier: Apache-2.0
//
// The figures of a run as the laboratory's list, and the texts about its end.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "lab/record.hpp"
#include "machines/kung/options.hpp"

namespace trammel::kung {

std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& result);
std::string verdict(const lab::Settings& settings, const cosim::RunResult& result);
std::vector<std::string> remarks(const lab::Record& record);
void add_metrics(const lab::Record& record, nlohmann::ordered_json& json);

}  // namespace trammel::kung
