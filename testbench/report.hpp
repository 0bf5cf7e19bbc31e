// SPDX-License-Identifier: Apache-2.0
//
// What a person reads at the end of a run, as text for stdout.
#pragma once

#include <string>
#include <vector>

#include "testbench/metrics.hpp"

namespace trammel::testbench {

struct Finished {
  kung::Options options;
  Metrics metrics;
  kung::EndReason end = kung::EndReason::kDone;
};

std::string run_report(const kung::Options& options, const kung::Result& result,
                       const Metrics& metrics, const std::string& folder,
                       const std::string& page);  // report.html, or empty

// How it ended, in one line: "followed 628 points", "TRIPPED: ...".
std::string verdict_text(const kung::Options& options, const kung::Result& result);

// Kung Table 2 and the step figures beside ours, from the eight experiments.
std::string experiments_report(const std::vector<Finished>& runs);

}  // namespace trammel::testbench
