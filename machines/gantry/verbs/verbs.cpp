// SPDX-License-Identifier: Apache-2.0
//
// The verb `serial`: a scenario whose host is a program at a pseudo-terminal, in real time.
#include <string>
#include <vector>

#include "machines/gantry/machine_members.hpp"
#include "testbench/run.hpp"

namespace trammel::gantry {
namespace {

int serial(const testbench::Arguments& arguments, std::atomic<bool>& stop) {
  testbench::Arguments run = arguments;
  if (run.scenario.empty()) run.scenario = "gantry-cascade";
  run.assignments.insert(run.assignments.begin(), "name=serial");
  run.live = true;
  return testbench::run(run, stop);
}

}  // namespace

std::vector<testbench::Verb> verbs() {
  testbench::Verb verb;
  verb.name = "serial";
  verb.help = "the gantry track behind a serial port, a pseudo-terminal in real time, to Ctrl-C";
  verb.argument = "scenario";
  verb.argument_help = "a scenario of the machine gantry; default: gantry-cascade";
  verb.out_help = "output folder; default: out/serial";
  verb.simulates = true;
  verb.trigger_help = "event that the window of waves is anchored to: irq, drive, region == 2";
  verb.perform = serial;
  return {verb};
}

}  // namespace trammel::gantry
