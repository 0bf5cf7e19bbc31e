// SPDX-License-Identifier: Apache-2.0
//
// Whether the table is where its program has it, by the true places of its rotors; and how far its
// program came.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <vector>

#include "machines/larson/machine_members.hpp"

namespace trammel::larson {
namespace fs = std::filesystem;
namespace {

char name_of_axis(std::size_t axis) { return axis == 0 ? 'X' : 'Y'; }

// [step] Farthest from its place that slips have put a rotor.
int most_lost(const std::vector<plant::StepsLost>& slips) {
  int now = 0, most = 0;
  for (const plant::StepsLost& one : slips) {
    now += one.steps;
    most = std::max(most, std::abs(now));
  }
  return most;
}

// "X lost 10 steps in 3 slips; the first at step 1234, 0.512 s into the run", or, where slips took
// each other back, "X lost up to 20 steps in 3 slips, 10 at the end; ...".
std::string losses(const Options& options, const Result& result, std::size_t axis) {
  const auto& slips = result.slips[axis];
  const int most = most_lost(slips), last = result.lost[axis];
  return fmt::format("{} lost {}{} steps{}{}; the first at step {:.0f}, {:.3f} s into the run",
                     name_of_axis(axis), most == last ? "" : "up to ", most,
                     slips.size() > 1 ? fmt::format(" in {} slips", slips.size()) : "",
                     most == last ? "" : fmt::format(", {} at the end", last), slips.front().at,
                     options.run.seconds(slips.front().edge));
}

// The axis that is farther from where its program has it, or "" where both are there.
std::string place_missed(const Options& options, const Result& result) {
  const std::array<double, 2> known{static_cast<double>(result.known.x),
                                    static_cast<double>(result.known.y)};
  std::array<double, 2> off{};
  for (std::size_t k = 0; k < 2; ++k) off[k] = result.end_at[k] - result.origin[k] - known[k];
  const std::size_t worse = std::fabs(off[1]) > std::fabs(off[0]) ? 1 : 0;
  if (std::fabs(off[worse]) <= options.reached_steps) return "";
  return fmt::format("{} is {:.1f} steps from {:.0f}, where its program has it "
                     "(run.reached_steps)", name_of_axis(worse), off[worse], known[worse]);
}

}  // namespace

std::string breach_text(const plant::StepBreach& breach, std::int64_t clock_ps) {
  const double us = 1e6 * cosim::seconds_of(breach.clocks, clock_ps);
  switch (breach.kind) {
    case plant::StepBreach::Kind::kWidth:
      return fmt::format("its pulse was {:.2f} us wide, below translator.width_us", us);
    case plant::StepBreach::Kind::kSetup:
      return fmt::format("direction turned {:.2f} us before its pulse, below translator.setup_us",
                         us);
    default:
      return fmt::format("direction turned {:.2f} us behind the edge of its pulse, below "
                         "translator.hold_us", us);
  }
}

std::string what_was_running(const Options& options, const Result& result) {
  const std::size_t ended = result.done.size();
  const auto at = [&result](std::size_t k) -> const Call& { return result.calls[k]; };
  // A WAIT has ended for its program as soon as the timer runs.
  const bool waits =
      ended > 0 && at(ended - 1).call.op == sw::LarsonOp::kWait &&
      result.done.back().edge + at(ended - 1).call.a > options.run.clocks(options.run.max_s);
  const bool running = waits || ended < result.calls.size();
  const Call& call = at(waits || !running ? ended - 1 : ended);
  const std::string file = fs::path(script_file(options.script)).filename();
  const std::string line = call.line == 0 ? "" : fmt::format("{}:", call.line);  // 0: of no line
  return fmt::format("{}:{} {} {}", file, line, call.text,
                     running ? "was running" : "had ended, the moves or record.settle_s had not");
}

std::string what_missed(const Options& options, const Result& result) {
  const bool failed = result.end == cosim::EndReason::kFault;
  std::optional<std::size_t> worse;
  for (std::size_t k = 0; k < 2; ++k) {
    // A table whose switch fails is driven into its stop: what it loses there is no news.
    const auto& slips = result.slips[k];
    if (slips.empty() || (failed && slips.front().at_stop)) continue;
    if (!worse || most_lost(slips) > most_lost(result.slips[*worse])) worse = k;
  }
  if (worse) return losses(options, result, *worse) + (failed ? "; " + result.fault : "");
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& breaches = result.breaches[k];
    if (breaches.empty()) continue;
    return fmt::format("{} pulse{} of {} made no step; the first {:.3f} s into the run, as {}",
                       breaches.size(), breaches.size() == 1 ? "" : "s", name_of_axis(k),
                       options.run.seconds(breaches.front().edge),
                       breach_text(breaches.front(), options.run.clock_ps)) +
           (failed ? "; " + result.fault : "");
  }
  if (failed || !(result.calibrated || result.stopped != 0)) return "";
  const std::string place = place_missed(options, result);
  if (result.stopped == 0) return place;
  constexpr std::array<const char*, 4> kAxis{"", "X", "Y", "X and Y"};
  return fmt::format("a switch stopped {}, and no CALTBL followed{}{}",
                     kAxis[result.stopped & 3], place.empty() ? "" : "; ", place);
}

}  // namespace trammel::larson
