// SPDX-License-Identifier: Apache-2.0
//
// A run of the precision controller beside the fuzzy controllers and the paper.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "lab/record.hpp"
#include "machines/kung/options.hpp"

namespace trammel::kung {

// The fuzzy controllers on the same feed profile, by their twins.
std::vector<lab::Companion> precision_companions(const lab::Settings& settings);

// What the page needs of a run of the precision controller besides: the highest feed of its path,
// and what the paper prints of it.
void add_precision(const Options& options, nlohmann::ordered_json& json);

// Errors of a run of the precision controller beside those of its companions, and of the paper.
std::vector<std::string> comparison_lines(const lab::Record& record);

std::string controller_name(const lab::Settings& settings);  // of a run among them

}  // namespace trammel::kung
