// SPDX-License-Identifier: Apache-2.0
//
// What a motor and its supply cannot give for the path that is asked, told before a run.
#pragma once

#include <string>
#include <vector>

#include "machines/kung/options.hpp"

namespace trammel::kung {

std::vector<std::string> warnings(const lab::Settings& settings);

}  // namespace trammel::kung
