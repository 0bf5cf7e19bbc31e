// SPDX-License-Identifier: Apache-2.0
//
// The first 20 ms of a run of any machine, by its twin, with a given end: for tests of what is made
// from runs, whatever the machine.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lab/machine.hpp"
#include "lab/record.hpp"
#include "lab/scenarios.hpp"
#include "testbench/run.hpp"

namespace trammel::test {

inline std::unique_ptr<cosim::RunResult> short_result(const lab::Settings& settings,
                                                      cosim::EndReason end) {
  const auto asked = settings.clone();
  if (settings.machine().can.twin) asked->run.engine = cosim::Engine::kTwin;
  asked->run.platform = cosim::Platform::kDirect;
  asked->run.wave = cosim::WaveFormat::kNone;
  asked->run.leap = true;
  asked->run.audit = asked->run.assertions = false;
  asked->run.max_s = 0.02;
  auto result = std::move(lab::run(*asked).result);
  result->end = end;
  if (end == cosim::EndReason::kAssertion) {
    result->assertion = {"no_shoot_through", "chip.u_leg", "drive/gate_leg_props.sv:7", 617283};
  }
  return result;
}

inline lab::Record short_run(const lab::Settings& settings, cosim::EndReason end) {
  return lab::judged(settings.clone(), short_result(settings, end));
}

inline testbench::Simulate ending(cosim::EndReason end) {
  return [end](const lab::Settings& settings, const cosim::Hooks&) {
    return short_run(settings, end);
  };
}

// The first of a machine's own scenarios.
inline std::string scenario_of(const lab::Machine& machine) {
  for (const auto& file : lab::scenarios()) {
    if (&lab::machine_of(file) == &machine) return file.stem().string();
  }
  throw std::logic_error("no scenario of " + machine.name);
}

// The arguments of `trammel run SCENARIO -o OUT -s ...`.
inline testbench::Arguments arguments_for(const std::string& scenario,
                                          const std::filesystem::path& out,
                                          std::vector<std::string> assignments = {}) {
  testbench::Arguments arguments;
  arguments.scenario = scenario;
  arguments.out = out.string();
  arguments.assignments = std::move(assignments);
  return arguments;
}

inline int run(const testbench::Arguments& arguments, const testbench::Simulate& simulate) {
  const std::atomic<bool> stop{false};
  return testbench::run(arguments, stop, simulate);
}

}  // namespace trammel::test
