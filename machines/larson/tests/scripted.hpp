// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "lab/record.hpp"
#include "machines/larson/machine_members.hpp"
#include "tests/support/scratch.hpp"

namespace trammel::larson {

// A run of a script, without SystemC but where a test asks for it. Cases of a program may run at
// the same time, each in a process of its own.
struct ScriptRun {
  test::Scratch scratch{"larson_scripted_" + std::to_string(getpid())};
  Options options;

  explicit ScriptRun(const std::string& script) {
    const std::filesystem::path file = scratch.path / "script.table";
    std::ofstream(file) << script;
    options.script = file.string();
    options.run.platform = cosim::Platform::kDirect;
  }
  Result run() const { return lab::simulate(options); }
};

// The same by the twin, and short: its axes are near their low switches, unlike in place.
struct ScriptedTwin : ScriptRun {
  explicit ScriptedTwin(const std::string& script) : ScriptRun(script) {
    options.run.engine = cosim::Engine::kTwin;
    options.start_x = 12;
    options.start_y = 31;
    options.settle_s = 0.03;
  }
};

}  // namespace trammel::larson
