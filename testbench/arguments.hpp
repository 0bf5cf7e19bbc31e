// SPDX-License-Identifier: Apache-2.0
//
// What a command line asks for, and the verbs that machines add to it.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lab/settings.hpp"
#include "lab/waves.hpp"

namespace trammel::testbench {

struct Arguments {
  std::string scenario;                  // or another positional argument
  std::vector<std::string> folders;      // of runs, for `report`; none: the latest in out/
  std::vector<std::string> files;        // -c
  std::vector<std::string> assignments;  // -s
  std::vector<std::pair<std::string, std::string>> keys;  // {"--audit", "run.audit=true"}
  lab::WaveArguments waves;              // --wave, --wave-*
  std::string out;
  bool all = false;
  bool json = false;
  bool report = true;                    // report.html in the folder
  bool activity = false;                 // also of each clock domain
  bool check = false;                    // exit 1 when a figure is outside its tolerance
  bool live = false;                     // another program takes part, in real time
  std::set<std::string> flags;           // those of a machine's verb
};

// -c, the environment, -s and the options that set keys: what lies above a scenario.
void apply_layers(lab::Settings& settings, const Arguments& arguments);

// A scenario with all that lies above it, checked. Throws ConfigError.
std::unique_ptr<lab::Settings> layered(const std::filesystem::path& file,
                                       const Arguments& arguments);

// A verb that one machine has: machines/<name>/verbs/verbs.cpp defines a list of them.
struct Verb {
  struct Flag {
    std::string name;  // "--listing"
    std::string help;
  };
  std::string name, help;
  std::string argument, argument_help;  // its positional argument: "script"
  std::string out_help;                 // of -o
  bool simulates = false;               // takes --audit, --assert, --wave...
  std::string trigger_help;             // of --wave-trigger, then
  std::vector<Flag> flags;
  bool (*is_conversation)(const Arguments&) = nullptr;  // a person types: Ctrl-C ends a wait only
  int (*perform)(const Arguments&, std::atomic<bool>& stop) = nullptr;  // the exit code
};

const std::vector<Verb>& machine_verbs();

}  // namespace trammel::testbench
