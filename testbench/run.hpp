// SPDX-License-Identifier: Apache-2.0
//
// The verb `run`: layers of options in, a finished output folder and a report out.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cosim/kung/types.hpp"
#include "cosim/lm628/types.hpp"
#include "cosim/mcafee/types.hpp"
#include "testbench/waves.hpp"

namespace trammel::testbench {

using Simulate = std::function<kung::Result(const kung::Options&, const kung::Hooks&)>;
using SimulateAn693 = std::function<lm628::Result(const lm628::Options&, const cosim::Hooks&)>;
using SimulateMcafee =
    std::function<mcafee::Result(const mcafee::Options&, const cosim::Hooks&)>;

struct RunArguments {
  std::string scenario;
  std::vector<std::string> files;        // -c
  std::vector<std::string> assignments;  // -s
  bool plain = false;                    // --no-leap, as its key
  bool audit = false;                    // --audit, as its key
  bool assertions = false;               // --assert, as its key
  std::string engine;                    // --engine, as its key
  std::string platform;                  // --platform, as its key
  WaveArguments waves;                   // --wave, --wave-*
  std::string out;
  bool all = false;
  bool json = false;
  bool report = true;                    // report.html in the folder
  bool listing = false;                  // track: the rows as bytes of the listing
  bool check = false;                    // exit 1 when a figure is outside its tolerance
};

// -c, the environment, -s and the flags that are keys: what lies above a scenario.
template <class Options>
void apply_own_layers(Options& options, const RunArguments& arguments);

// The scenario's file says which machine it is of.
int run(const RunArguments& arguments, const Simulate& simulate, const std::atomic<bool>& stop,
        const SimulateAn693& simulate_an693 = {}, const SimulateMcafee& simulate_mcafee = {});

// Options of a machine other than kung, from all layers and checked.
template <class Options>
Options layered_machine(const std::filesystem::path& file, const RunArguments& arguments);

}  // namespace trammel::testbench
