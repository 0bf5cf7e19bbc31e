// SPDX-License-Identifier: Apache-2.0
//
// Runs of built-in scenarios, and the figures of their steps.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "machines/gantry/machine_members.hpp"

namespace trammel::gantry_test {

inline constexpr double kCount_mm = 5.0 / 32;  // a count of control

inline gantry::Options built_in(const std::string& scenario,
                                cosim::Engine engine = cosim::Engine::kTwin) {
  auto settings = lab::load_scenario(lab::find_scenario(scenario));
  auto options = static_cast<const gantry::Options&>(*settings);
  options.run.platform = cosim::Platform::kDirect;
  options.run.engine = engine;
  return options;
}

inline gantry::Result done(const gantry::Options& options) {
  gantry::Result result = lab::simulate(options);
  REQUIRE(result.end == cosim::EndReason::kDone);
  CHECK(result.malformed == 0);
  CHECK(result.unknown == 0);
  return result;
}

inline gantry::StepFigures step_of(const gantry::Options& options) {
  return gantry::step_figures(options, done(options));
}

// Overshoot of the step [%].
inline double percent(const gantry::Options& options) {
  return 100 * step_of(options).overshoot_mm / (options.reference_mm - options.from_mm);
}

inline double time_of(const gantry::Sample& s) { return 2e-8 * static_cast<double>(s.edge); }

}  // namespace trammel::gantry_test
