// SPDX-License-Identifier: Apache-2.0
//
// What run.cpu excludes, and what a run tells of its processor.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "machines/kung/chip/record.hpp"

namespace trammel::kung {

void check_cpu(const Options& options);
std::vector<std::string> cpu_lines(const Options& options, const Result& result);
void add_cpu(const Options& options, const Result& result, nlohmann::ordered_json& json);

}  // namespace trammel::kung
