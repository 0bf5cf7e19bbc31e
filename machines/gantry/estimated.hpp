// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "lab/figure.hpp"
#include "machines/gantry/record.hpp"

namespace trammel::gantry {

std::vector<lab::Figure> open_figures(const Options& options, const Result& result);
std::vector<std::string> open_remarks(const Result& result);  // of an identification

}  // namespace trammel::gantry
