// SPDX-License-Identifier: Apache-2.0
#include "machines/larson/plant.hpp"

namespace trammel::larson {

plant::StepperAxisConfig axis_of(const Options& options, double start) {
  plant::StepperAxisConfig axis = options.run.clocked(options.axis);
  axis.start = start;
  axis.input = {1e-6 * options.width_us, 1e-6 * options.setup_us, 1e-6 * options.hold_us};
  return axis;
}

}  // namespace trammel::larson
