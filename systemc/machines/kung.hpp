// SPDX-License-Identifier: Apache-2.0
//
// The X-Y table of Kung 2012: one call is one run, wired by SystemC or directly.
#pragma once

#include "cosim/kung/types.hpp"

namespace trammel::kung {

// Throws OptionsError or std::invalid_argument for options that cannot run; faults and divergence
// are values in the Result. Runs one at a time in a process.
Result simulate(const Options& options, const Hooks& hooks);

}  // namespace trammel::kung
