// SPDX-License-Identifier: Apache-2.0
//
// Figures printed by Kung et al. 2012 (DOI 10.5772/48457), and those that the specification expects
// of this machine (section 12) with their tolerances.
#pragma once

#include <vector>

#include "lab/figure.hpp"
#include "machines/kung/options.hpp"

namespace trammel::kung {

// True when the run is one of the paper's eight experiments, with nothing but seed, platform,
// name and waves changed.
bool is_paper_experiment(const Options& options);

// Sets what is printed and expected in the figures of a complete run of such an experiment.
void compare(const Options& options, std::vector<lab::Figure>& figures);

// What must be said wherever Table 2 is shown (specification section 14.14).
inline constexpr char kCircleNote[] =
    "not reproduced: the paper's 33.3 % smaller spread of the circle under AFC (0.60 -> 0.40)";

}  // namespace trammel::kung
