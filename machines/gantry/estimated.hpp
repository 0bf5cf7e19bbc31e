// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "lab/figure.hpp"
#include "machines/gantry/record.hpp"

namespace trammel::gantry {

std::vector<lab::Figure> open_figures(const Options& options, const Result& result);
nlohmann::ordered_json identified_json(const Result& result);  // empty: no model
std::vector<std::string> open_remarks(const Result& result);  // of an identification

}  // namespace trammel::gantry
