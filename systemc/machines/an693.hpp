// SPDX-License-Identifier: Apache-2.0
//
// An LM628 that drives a DC motor: one call is one run, wired by SystemC or directly.
#pragma once

#include "cosim/lm628/types.hpp"

namespace trammel::lm628 {

// Faults and divergence are values in the Result. Runs one at a time in a process.
Result simulate(const Options& options, const cosim::Hooks& hooks);

}  // namespace trammel::lm628
