// SPDX-License-Identifier: Apache-2.0
//
// A run that tracks beside others of the same path at constant speeds.
#include <fmt/format.h>

#include "machines/mcafee/machine_members.hpp"

namespace trammel::mcafee {
namespace {

constexpr int kMostFeed = 254;  // what the feed rate gives at most

std::string name_of(int speed) { return fmt::format("v = {}", speed); }

}  // namespace

std::vector<lab::Companion> companions(const lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  std::vector<lab::Companion> all;
  if (!options.tracks() || !options.compare) return all;
  for (const int speed : {kMostFeed, options.least_speed}) {
    auto other = std::make_unique<Options>(options);
    other->speed = speed;
    other->run.wave = cosim::WaveFormat::kNone;  // waves are of the first
    all.push_back({name_of(speed), std::move(other)});
  }
  return all;
}

std::string run_name(const lab::Settings& settings) {
  const auto& options = static_cast<const Options&>(settings);
  if (!options.tracks()) return "motion";
  return options.speed == 0 ? "self-paced" : name_of(options.speed);
}

}  // namespace trammel::mcafee
