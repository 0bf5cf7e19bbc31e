// SPDX-License-Identifier: Apache-2.0
//
// The words of an LM628's samples that a trigger may name, as in trace.csv.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "parts/lm628/chip.hpp"
#include "cosim/trigger.hpp"

namespace trammel::lm628 {

// Of one part; of_axis where there are two.
std::vector<cosim::Signal> signals_of_part(bool of_axis);

const std::vector<cosim::Signal>& signals();

// The value of signals()[signal].
std::int64_t word(const Words& words, std::size_t signal);

}  // namespace trammel::lm628
