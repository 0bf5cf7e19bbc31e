// SPDX-License-Identifier: Apache-2.0
//
// Which settings the description of a scenario tells, and how it reads after they were altered.
#pragma once

#include <string>

#include "lab/machine.hpp"

namespace trammel::kung {

bool alters(const lab::Key& key, const lab::Value& value);
std::string reworded(const lab::Settings& settings, std::string description);

}  // namespace trammel::kung
