// SPDX-License-Identifier: Apache-2.0
//
// The verbs of the program.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "lab/record.hpp"
#include "testbench/arguments.hpp"
#include "testbench/streams.hpp"

namespace trammel::testbench {

// Layers of settings in, a finished output folder and a report out; the exit code. `simulate` is
// lab::run but in tests.
using Simulate = std::function<lab::Record(const lab::Settings&, const cosim::Hooks&)>;
int run(const Arguments& arguments, const std::atomic<bool>& stop,
        const Simulate& simulate = lab::run);

// The page of the folders, or of the latest run in out/ where there are none.
int report(const Arguments& arguments);

// Lists, and what is installed: doctor.cpp.
int list(const std::string& topic, const std::string& machine, bool json);
int doctor(bool json);
std::string version_text();

// What this program lacks is built by the launcher that started it, which then starts the program
// of that name with these arguments. Returns if no launcher started it.
void hand_over(const std::string& program, char** argv);

// 130 and a line for a run that came to its end, but whose files were being written when a signal
// came; 0 without one.
int late_stop(const std::string& name, const std::string& folder, const std::atomic<bool>& stop);

}  // namespace trammel::testbench
