// SPDX-License-Identifier: Apache-2.0
//
// The boundary between the program and the machine: one call is one run. Throws OptionsError for a
// combination that cannot run; faults and divergence are values in the Result.
#pragma once

#include "cosim/kung/types.hpp"

namespace trammel::kung {

Result simulate(const Options& options, const Hooks& hooks);

}  // namespace trammel::kung
