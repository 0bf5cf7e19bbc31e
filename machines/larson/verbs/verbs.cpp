// SPDX-License-Identifier: Apache-2.0
//
// The verb `table`: a script of .TABLE calls, or a list of moves, at the simulated table.
#include <algorithm>
#include <filesystem>

#include "host/errors.hpp"
#include "lab/scenarios.hpp"
#include "machines/larson/machine_members.hpp"
#include "testbench/run.hpp"

namespace trammel::larson {
namespace {

// A run of the calibrating scenario with another script, under the script's name.
int table(const testbench::Arguments& arguments, std::atomic<bool>& stop) {
  if (arguments.scenario.empty()) {
    throw host::ConfigError("table: name a script of calls, or a list of moves that ends in .csv");
  }
  testbench::Arguments run = arguments;
  run.scenario = "larson-calibrate";
  const std::string name = std::filesystem::path(arguments.scenario).stem().string();
  const std::vector<std::string> ours{"script=" + arguments.scenario, "name=table-" + name};
  run.assignments.insert(run.assignments.begin(), ours.begin(), ours.end());
  return testbench::run(run, stop);
}

}  // namespace

std::vector<testbench::Verb> verbs() {
  testbench::Verb verb;
  verb.name = "table";
  verb.help = "run a script of .TABLE calls, or a list of moves, on the stepper table of Larson";
  verb.argument = "script";
  verb.argument_help = "a built-in script or a file; one that ends in .csv holds x,y,pen";
  verb.out_help = "output folder; default: out/table-SCRIPT";
  verb.simulates = true;
  verb.trigger_help = "event that the window of waves is anchored to: irq, drive, x.count == 65535";
  verb.perform = table;
  return {verb};
}

}  // namespace trammel::larson
