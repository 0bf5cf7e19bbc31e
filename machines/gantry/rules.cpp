// SPDX-License-Identifier: Apache-2.0
//
// Rules that concern more than one key.
#include <fmt/format.h>

#include <cmath>

#include "machines/gantry/machine_members.hpp"

namespace trammel::gantry {
namespace {

[[noreturn]] void refuse(const char* key, const std::string& found, const std::string& permitted) {
  throw host::ConfigError(fmt::format("{}: {}; permitted: {}", key, found, permitted));
}

// Keys that choose how the track is driven: of two that exclude each other one would have no
// effect. Values of a part that is not chosen are permitted, so that one key chooses another.
void refuse_two_controls(const Options& options) {
  const sw::GantrySetup& firmware = options.firmware;
  const bool sums = firmware.position.sum != sw::PositionPi::Sum::kNone;
  if (firmware.cascade && firmware.position.bang) {
    refuse("position.bang_bang", "true, and control.cascade is true", "one of them");
  }
  if (firmware.cascade && sums) {
    refuse("position.sum", "a sum, and control.cascade is true, which has none of the position",
           "none, or control.cascade=false");
  }
  if (firmware.position.bang && sums) {
    refuse("position.sum", "a sum, and position.bang_bang is true, which has none",
           "none, or position.bang_bang=false");
  }
  if (firmware.compensate && !firmware.cascade) {
    refuse("control.compensate", "true, and control.cascade is false",
           "with control.cascade=true, whose motors it shares");
  }
  if (!options.estimator.model.empty() && options.estimator.filter != Filter::kKalman) {
    refuse("velocity.model", "a model, and velocity.filter is not kalman, which alone has one",
           "empty, or velocity.filter=kalman");
  }
}

// A force without a controller. The calibration run goes to its place by a controller first.
void refuse_beside_open(const Options& options) {
  const sw::GantrySetup& firmware = options.firmware;
  if (firmware.open == sw::OpenForce::kNone) return;
  const char* const chosen = firmware.cascade         ? "control.cascade is true"
                             : firmware.position.bang ? "position.bang_bang is true"
                             : firmware.position.sum != sw::PositionPi::Sum::kNone
                                 ? "position.sum is a sum"
                                 : nullptr;
  if (chosen != nullptr && !firmware.calibrate) {
    refuse("control.open", fmt::format("a force without a controller, and {}", chosen),
           "none, or no controller");
  }
  if (options.reached_mm >= 0) {
    refuse("run.reached_mm",
           fmt::format("{:g} mm, and control.open drives the cart to no reference",
                       options.reached_mm),
           "below 0, or control.open=none");
  }
  if (firmware.open_force == 0) {
    refuse("control.open_force", "0 moves nothing", "with control.open any other value");
  }
}

// What sets both, or the time last, wants that time; run.max_s that is set later cuts it short.
void refuse_long_time(const Options& options) {
  if (options.time_s <= options.run.max_s) return;
  const auto set = [&options](const char* key) {
    const auto found = options.set_by.find(key);
    return found == options.set_by.end() ? lab::SetBy{} : found->second;
  };
  const lab::SetBy time = set("run.time_s");
  if (set("run.max_s").layer > time.layer) return;
  throw host::ConfigError(
      fmt::format("{}run.time_s: {:g} s is above run.max_s, {:g} s; permitted: at most that",
                  time.where, options.time_s, options.run.max_s));
}

}  // namespace

void validate(lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  read_sends(options.sends);
  read_model(options.estimator.model);
  refuse_long_time(options);
  refuse_two_controls(options);
  refuse_beside_open(options);
  if (options.axis.stiction < options.axis.coulomb) {
    throw host::ConfigError(fmt::format(
        "axis.stiction_count: {:g} is below axis.coulomb_count, {:g}; permitted: at least that",
        options.axis.stiction, options.axis.coulomb));
  }
  if (options.firmware.position.least > options.firmware.position.most) {
    throw host::ConfigError(fmt::format(
        "position.min_force: {} is above position.max_force, {}; permitted: at most that",
        options.firmware.position.least, options.firmware.position.most));
  }
  const sw::GantrySetup& firmware = options.firmware;
  if (firmware.calibrate && !firmware.home) {
    throw host::ConfigError(
        "boot.calibrate: true, and boot.home is false; permitted: with boot.home=true, whose zero "
        "the calibration run counts from");
  }
  if (firmware.compensate && firmware.motors != sw::Motors::kBoth) {
    throw host::ConfigError(
        "control.compensate: true takes two motors; permitted: control.motors = both");
  }
  const double passes = kEstimate_ms / options.pass_ms;
  const bool samples = options.estimator.filter != Filter::kMean ||
                       firmware.open == sw::OpenForce::kRandom;
  if (samples && std::fabs(passes - std::round(passes)) > 1e-9) {
    throw host::ConfigError(fmt::format(
        "control.pass_ms: {:g} is no part of {:g} ms, in which filter and identification sample; "
        "permitted then: 0.5, 1, 2, 2.5, 5, 10 and other parts",
        options.pass_ms, kEstimate_ms));
  }
}

// What of host.sends no run of these settings sends.
std::vector<std::string> warnings(const lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  const auto sends = read_sends(options.sends);
  if (options.serial || sends.empty() || sends.back().at_s < options.time_s) return {};
  return {fmt::format("host.sends: its last entry is at {:g} s, and the run ends at {:g} s "
                      "(run.time_s): it is not sent",
                      sends.back().at_s, options.time_s)};
}

}  // namespace trammel::gantry
