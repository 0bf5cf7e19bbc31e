// SPDX-License-Identifier: Apache-2.0
//
// What run.cpu excludes, the core that it asks for, and what a run tells of its processor.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "machines/kung/chip/record.hpp"
#include "machines/kung/chip/soc.hpp"

namespace trammel::kung {

void check_cpu(const Options& options);
// Throws host::ToolMissing.
std::unique_ptr<SocCore> core_of(const Options& options, const sw::KungSetup& setup);
std::vector<std::string> cpu_lines(const Options& options, const Result& result);
void add_cpu(const Options& options, const Result& result, nlohmann::ordered_json& json);

}  // namespace trammel::kung
