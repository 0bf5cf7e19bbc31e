// SPDX-License-Identifier: Apache-2.0
//
// Why the program gave up, and why a run that came to its end is not done.
#include <fmt/format.h>

#include <cmath>

#include "machines/gantry/machine_members.hpp"

namespace trammel::gantry {

const char* what_failed(const sw::GantryMailbox& mail) {
  switch (static_cast<sw::GantryFailure>(mail.failure)) {
    case sw::GantryFailure::kFitFailed: return "the calibration run was no steady motion";
    case sw::GantryFailure::kStalled: return "a force and no motion";
    case sw::GantryFailure::kSensor: return "A and B are not on their circle";
    case sw::GantryFailure::kNone: break;
  }
  return "";
}

std::string what_noticed(const sw::GantryMailbox& mail, const Words& words) {
  if (mail.failure != 0) return what_failed(mail);
  if (words.malformed > 0) return "malformed frame";
  if (mail.unchecked > 0) return "frame without its checksum";
  if (mail.refused > 0) return "goal outside the track";
  if (mail.unknown > 0) return "unknown channel";
  return "";
}

std::string what_missed(const Options& options, const Result& result) {
  if (result.phase == sw::GantryPhase::kHoming) return "homing did not end";
  if (result.phase == sw::GantryPhase::kToFit || result.phase == sw::GantryPhase::kFitting) {
    return "the calibration run did not end";
  }
  if (options.reached_mm < 0 || result.looks.empty()) return "";
  const StepFigures step = step_figures(options, result);
  if (!step.begun) return "the run ended before the last of host.sends (run.reached_mm)";
  if (std::fabs(step.rest_mm) <= options.reached_mm) return "";
  return fmt::format("the cart is {:.2f} mm from its reference (run.reached_mm)", step.rest_mm);
}

std::string verdict(const lab::Settings& settings, const cosim::RunResult& run) {
  return run.end == cosim::EndReason::kFault ? "failed: " + run.fault_text()
                                             : lab::verdict_text(settings, run);
}

}  // namespace trammel::gantry
