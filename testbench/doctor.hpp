// SPDX-License-Identifier: Apache-2.0
//
// The verbs that only look: `list`, `doctor`, `--version`.
#pragma once

#include <string>

namespace trammel::testbench {

int list(const std::string& topic, const std::string& machine, bool json);
int doctor(bool json);
std::string version_text();

}  // namespace trammel::testbench
