// SPDX-License-Identifier: Apache-2.0
//
// Members of the description in machine.cpp that are in other units.
#pragma once

#include <vector>

#include "lab/machine.hpp"

namespace trammel::@name@ {

const std::vector<lab::Key>& keys();   // keys.cpp
const lab::ColumnTable& columns();     // figures.cpp, as what follows
std::vector<lab::Figure> figures(const lab::Settings& settings, cosim::RunResult& result);

}  // namespace trammel::@name@
