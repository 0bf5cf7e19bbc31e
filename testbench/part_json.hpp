// SPDX-License-Identifier: Apache-2.0
//
// Words of an LM628, and what metrics.json says of every run of machines with such parts.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "testbench/config.hpp"
#include "testbench/keys.hpp"
#include "testbench/output.hpp"

namespace trammel::testbench {

inline constexpr double kPerCount = 65536;  // of a position or speed

inline std::int64_t clock_ps_of(const lm628::Options& options) { return options.plant.clock_ps; }
inline std::int64_t clock_ps_of(const mcafee::Options& options) {
  return options.stage_axis.clock_ps;
}

// How it ended, in one line; a script's own words where it could not go on.
template <class Options, class Result>
std::string part_verdict(const Options& options, const Result& result) {
  switch (result.end) {
    case cosim::EndReason::kDone: return "done";
    case cosim::EndReason::kFault: return "tripped: " + result.fault;
    case cosim::EndReason::kDiverged:
      return fmt::format("diverged: error above run.diverged_counts = {}",
                         options.run.diverged_counts);
    case cosim::EndReason::kTimeout:
      return result.fault.empty() ? fmt::format("not finished within run.max_s = {:g}",
                                                options.run.max_s)
                                  : result.fault;
    case cosim::EndReason::kPromise:
      return "promise broken: " + promise_text(*result.promise, clock_ps_of(options));
    default: return end_text(result.end);
  }
}

// Machine, scenario, and how it ended; `command` repeats the run.
template <class Options, class Result>
nlohmann::ordered_json head_json(const Options& options, const Result& result,
                                 const std::string& command) {
  nlohmann::ordered_json json;
  json["machine"] = machine_name<Options>();
  json["scenario"] = options.scenario;
  json["command"] = command;
  json["end"] = end_text(result.end);
  json["verdict"] = part_verdict(options, result);
  if (!result.fault.empty()) json["fault"] = result.fault;
  if (result.promise) json["promise"] = promise_json(*result.promise);
  return json;
}

// Length and speed of the simulation.
template <class Result>
nlohmann::ordered_json simulation_json(const Result& result, std::int64_t clock_ps) {
  const double simulated = cosim::seconds_of(result.clocks, clock_ps);
  return {{"samples", result.samples.size()},
          {"clock_ps", clock_ps},
          {"clocks", result.clocks},
          {"clocks_evaluated", result.evaluated},
          {"simulated_s", simulated},
          {"wall_s", result.wall_s},
          {"real_time_factor", result.wall_s > 0 ? simulated / result.wall_s : 0},
          {"event_hash", fmt::format("{:016x}", result.event_hash)}};
}

}  // namespace trammel::testbench
