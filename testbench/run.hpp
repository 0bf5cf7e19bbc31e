// SPDX-License-Identifier: Apache-2.0
//
// The verbs `run` and `report`.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "lab/record.hpp"
#include "testbench/arguments.hpp"

namespace trammel::testbench {

// Layers of settings in, a finished output folder and a report out; the exit code. `simulate` is
// lab::run but in tests.
using Simulate = std::function<lab::Record(const lab::Settings&, const cosim::Hooks&)>;
int run(const Arguments& arguments, const std::atomic<bool>& stop,
        const Simulate& simulate = lab::run);

// A line on stderr for a run that did not end as it should; the exit code.
int tell_end(const lab::Record& record, const std::string& name, const std::string& folder);

void tell(const std::string& text);  // a line on stderr

// The page of the folders, or of the latest run in out/ where there are none.
int report(const Arguments& arguments);

}  // namespace trammel::testbench
