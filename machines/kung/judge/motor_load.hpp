// SPDX-License-Identifier: Apache-2.0
//
// What motors and drives had to give in a run, as figures, and where a rating was exceeded.
#pragma once

#include <string>
#include <vector>

#include "lab/figure.hpp"
#include "machines/kung/chip/record.hpp"

namespace trammel::kung {

// rms current, rms thrust and copper loss of each axis.
void add_motor_load(std::vector<lab::Figure>& list, const Options& options, const Result& result);

// A line for each rating of a motor that the run exceeds.
std::vector<std::string> overloads(const Options& options, const Result& result);

}  // namespace trammel::kung
