// SPDX-License-Identifier: Apache-2.0
#include "machines/gantry/setup.hpp"

#include <algorithm>
#include <cmath>

#include "machines/gantry/plant.hpp"

namespace trammel::gantry {

sw::GantrySetup setup_of(const Options& options) {
  sw::GantrySetup setup = options.firmware;
  setup.pass_clk = static_cast<std::uint32_t>(options.run.clocks(1e-3 * options.pass_ms));
  setup.open_passes = static_cast<std::uint32_t>(
      std::max(1.0, std::round(options.open_hold_ms / options.pass_ms)));
  // From byte to byte: the silence, and a byte with a bit to spare.
  setup.gap_clk = options.gap_ms == 0 ? 0
                                      : static_cast<std::uint32_t>(
                                            options.run.clocks(1e-3 * options.gap_ms) +
                                            11 * TrackPlant::kClocksPerBit);
  return setup;
}

bool identifies(const Options& options) {
  return options.firmware.open == sw::OpenForce::kRandom;
}

std::unique_ptr<Estimator> estimator_of(const Options& options) {
  if (options.estimator.filter == Filter::kMean && !identifies(options)) return nullptr;
  return std::make_unique<Estimator>(options.estimator, options.pass_ms, identifies(options));
}

}  // namespace trammel::gantry
