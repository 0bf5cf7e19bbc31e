// SPDX-License-Identifier: Apache-2.0
#include "lab/record.hpp"

#include <fmt/format.h>

#include "lab/machine.hpp"
#include "lab/wiring.hpp"

namespace trammel::lab {

std::unique_ptr<cosim::RunResult> simulate(const Settings& settings, const cosim::Hooks& hooks) {
  const Machine& machine = settings.machine();
  const cosim::MakeSession make = [&](const cosim::Hooks& own, const cosim::Waves& waves) {
    return machine.session(settings, own, waves);
  };
  return with_config_errors(
      [&] { return simulate(settings.run, machine.traces.triggers(), make, hooks); });
}

Record judged(std::shared_ptr<const Settings> settings, std::unique_ptr<cosim::RunResult> result) {
  const Machine& machine = settings->machine();
  Record record;
  if (machine.compared.run_name != nullptr) record.name = machine.compared.run_name(*settings);
  record.figures = machine.figures(*settings, *result);
  if (result->supplied_J) {
    record.figures.push_back(
        figure("supply.energy_J", "energy from the supply", "", *result->supplied_J, "J"));
  }
  record.verdict = machine.verdict(*settings, *result);
  record.settings = std::move(settings);
  record.result = std::move(result);
  return record;
}

Record run(const Settings& settings, const cosim::Hooks& hooks) {
  const Simulate simulated = [](const Settings& one, const cosim::Hooks& own) {
    return simulate(one, own);
  };
  return run_by(simulated, settings, hooks);
}

Record run_by(const Simulate& simulate, const Settings& settings, const cosim::Hooks& hooks) {
  const Machine& machine = settings.machine();
  Record record = judged(settings.clone(), simulate(settings, hooks));
  if (machine.compared.companions == nullptr || record.result->end != cosim::EndReason::kDone) {
    return record;
  }
  for (Companion& companion : machine.compared.companions(settings)) {
    auto result = simulate(*companion.settings, hooks);
    if (result->end == cosim::EndReason::kStopped) {  // a part of it is nothing to compare with
      record.result->end = cosim::EndReason::kStopped;
      record.verdict = machine.verdict(settings, *record.result);
      break;
    }
    record.companions.push_back(judged(std::move(companion.settings), std::move(result)));
    record.companions.back().name = companion.name;
    record.companions.back().printed = companion.printed;
  }
  return record;
}

const char* end_text(cosim::EndReason end) {
  switch (end) {
    case cosim::EndReason::kDone: return "done";
    case cosim::EndReason::kFault: return "tripped";
    case cosim::EndReason::kDiverged: return "diverged";
    case cosim::EndReason::kMissed: return "missed";
    case cosim::EndReason::kTimeout: return "timeout";
    case cosim::EndReason::kStopped: return "interrupted";
    case cosim::EndReason::kAssertion: return "assertion failed";
  }
  return "unknown";
}

std::string verdict_text(const Settings& settings, const cosim::RunResult& result) {
  const std::string fault = result.fault_text();
  switch (result.end) {
    case cosim::EndReason::kFault:
    case cosim::EndReason::kMissed: return fmt::format("{}: {}", end_text(result.end), fault);
    case cosim::EndReason::kTimeout:
      return fmt::format("not finished within run.max_s = {:g}{}{}", settings.run.max_s,
                         fault.empty() ? "" : ": ", fault);
    case cosim::EndReason::kAssertion:
      return fmt::format("{}: {}", end_text(result.end),
                         assertion_text(*result.assertion, result.clock_ps));
    default: return end_text(result.end);
  }
}

int exit_code(cosim::EndReason end) {
  switch (end) {
    case cosim::EndReason::kDone: return 0;
    case cosim::EndReason::kStopped: return 130;
    case cosim::EndReason::kAssertion: return 4;
    default: return 5;
  }
}

std::string assertion_text(const cosim::FailedAssertion& assertion, std::int64_t clock_ps) {
  return fmt::format("{} of {} at {:.8f} s, clock {} ({})", assertion.name,
                     assertion.instance.empty() ? "the chip" : assertion.instance,
                     cosim::seconds_of(assertion.edge, clock_ps), assertion.edge, assertion.place);
}

std::string cause_text(const cosim::RunResult& result) {
  if (result.assertion) return ": " + assertion_text(*result.assertion, result.clock_ps);
  const std::string fault = result.fault_text();
  if (fault.empty()) return "";
  const bool told = result.end == cosim::EndReason::kMissed ||
                    result.end == cosim::EndReason::kTimeout;
  return (told ? ": " : " by ") + fault;
}

}  // namespace trammel::lab
