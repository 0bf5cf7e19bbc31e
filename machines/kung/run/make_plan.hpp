// SPDX-License-Identifier: Apache-2.0
//
// Makes the plan of a run: converts physical options to the integers the firmware takes
// (specification sections 3, 10 and 11) and checks every rule that involves more than one option;
// the range of a single option is in plan/keys.cpp.
#pragma once

#include <memory>

#include "machines/kung/options.hpp"
#include "machines/kung/plan/plan.hpp"

namespace trammel::kung {

// Throws std::invalid_argument that names the key and the permitted range.
std::shared_ptr<const Plan> make_plan(const Options& options, PathFile file);
std::shared_ptr<const Plan> make_plan(const Options& options);  // reads the file of the path

// What validate() has made of these options; made now where there is none, or where a key has been
// changed since. Throws as make_plan() does.
std::shared_ptr<const Plan> plan_of(const Options& options);

void validate(lab::Settings& settings);

}  // namespace trammel::kung
