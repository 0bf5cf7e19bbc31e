// SPDX-License-Identifier: Apache-2.0
//
// Two LM628 that move a leadscrew stage: one call is one run, wired by SystemC or directly.
#pragma once

#include "cosim/mcafee/types.hpp"

namespace trammel::mcafee {

// Throws cosim::OptionsError for a path that cannot be followed; faults and divergence are values
// in the Result. Runs one at a time in a process.
Result simulate(const Options& options, const cosim::Hooks& hooks);

}  // namespace trammel::mcafee
