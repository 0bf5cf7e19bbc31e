// SPDX-License-Identifier: Apache-2.0
//
// What the program is told: the options in its own units, and a filter beside its own.
#pragma once

#include <memory>

#include "machines/gantry/options.hpp"

namespace trammel::gantry {

bool identifies(const Options& options);  // a random force without a controller
sw::GantrySetup setup_of(const Options& options);
std::unique_ptr<Estimator> estimator_of(const Options& options);  // null: its own is enough

}  // namespace trammel::gantry
