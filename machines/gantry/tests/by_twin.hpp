// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "machines/gantry/options.hpp"

namespace trammel::gantry {

// A run of the twin, without SystemC.
inline Options by_twin(double time_s) {
  Options options;
  options.run.engine = cosim::Engine::kTwin;
  options.run.platform = cosim::Platform::kDirect;
  options.time_s = time_s;
  return options;
}

}  // namespace trammel::gantry
