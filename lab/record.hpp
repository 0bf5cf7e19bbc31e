// SPDX-License-Identifier: Apache-2.0
//
// A finished run: what was asked for, what happened, and how it is judged.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cosim/run.hpp"
#include "host/errors.hpp"
#include "lab/figure.hpp"
#include "lab/settings.hpp"

namespace trammel::lab {

// A run that another one is compared with.
struct Companion {
  std::string name;
  std::unique_ptr<Settings> settings;
  bool printed = true;  // its figures; else what the machine says of both is enough
};

// Samples [first, last) of a record.
struct Range {
  std::size_t first = 0;
  std::size_t last = 0;
};

struct Record {
  std::string name;                          // among companions
  bool printed = true;                       // as of the companion
  std::shared_ptr<const Settings> settings;
  std::unique_ptr<cosim::RunResult> result;  // of the machine's own type
  std::vector<Figure> figures;
  std::string verdict;                       // how it ended, in one line
  std::vector<Record> companions;

  const Machine& machine() const { return settings->machine(); }
};

// What `work` returns; what only plant and firmware can tell of the settings is a ConfigError.
template <class Work>
auto with_config_errors(const Work& work) {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    throw host::ConfigError(error.what());
  } catch (const cosim::OptionsError& error) {
    throw host::ConfigError(error.what());
  }
}

// One run, of a result of the machine's own type. Faults and divergence are values in it. Throws
// ConfigError for settings that cannot run; they must have been validated.
std::unique_ptr<cosim::RunResult> simulate(const Settings& settings, const cosim::Hooks& hooks);

// The same where that type is known.
template <class Options, class Result = typename Options::Result>
Result simulate(const Options& options, const cosim::Hooks& hooks = {}) {
  const Settings& settings = options;
  return std::move(static_cast<Result&>(*simulate(settings, hooks)));
}

// Simulates: the run, and those it is compared with. Faults and divergence are values in the
// record. Throws ConfigError for settings that cannot run; they must have been validated.
Record run(const Settings& settings, const cosim::Hooks& hooks = {});

// The same, where each of these runs is what `simulate` gives.
using Simulate =
    std::function<std::unique_ptr<cosim::RunResult>(const Settings&, const cosim::Hooks&)>;
Record run_by(const Simulate& simulate, const Settings& settings, const cosim::Hooks& hooks = {});

// The figures and the verdict of a result that is there already.
Record judged(std::shared_ptr<const Settings> settings, std::unique_ptr<cosim::RunResult> result);

const char* end_text(cosim::EndReason end);  // "done", "tripped"...
// How a run ended, in one line, of a machine that has no more to say.
std::string verdict_text(const Settings& settings, const cosim::RunResult& result);
int exit_code(cosim::EndReason end);

// One line: assertion, instance, time and place.
std::string assertion_text(const cosim::FailedAssertion& assertion, std::int64_t clock_ps);

// Cause of an end that is an error: ": PROMISE", " by FAULT", or nothing.
std::string cause_text(const cosim::RunResult& result);

}  // namespace trammel::lab
