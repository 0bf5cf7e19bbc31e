// SPDX-License-Identifier: Apache-2.0
//
// detail.json of each machine that writes one, as its page needs it, and what is made of a record
// when it is read.
#pragma once

#include <filesystem>

#include "testbench/report_data.hpp"

namespace trammel::testbench {

// Throw ConfigError, which names the file and the member.
void check_kung_detail(const std::filesystem::path& file, const Json& detail);
void check_mcafee_detail(const std::filesystem::path& file, const Json& detail);

void complete_kung(RunRecord& run);
void complete_mcafee(RunRecord& run);

}  // namespace trammel::testbench
