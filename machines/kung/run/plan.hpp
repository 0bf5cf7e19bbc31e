// SPDX-License-Identifier: Apache-2.0
//
// Converts physical options to the integers the firmware takes (specification sections 3, 10 and
// 11) and checks every rule that involves more than one option; the range of a single option is in
// plan/keys.cpp. Throws std::invalid_argument that names the key and the permitted range.
#pragma once

#include <stdexcept>
#include <vector>

#include "machines/kung/options.hpp"
#include "machines/kung/plan/path.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::kung {

sw::KungSetup plan_firmware(const Options& options, PathStore& store);

// Of a path that the feed profile does not drive: `points` is all that it needs.
inline sw::KungSetup plan_firmware(const Options& options, std::vector<sw::Point>& points) {
  PathStore store;
  const sw::KungSetup setup = plan_firmware(options, store);
  if (setup.path == sw::Path::kFeed) throw std::invalid_argument("path.profile: needs a PathStore");
  points.swap(store.points);
  return setup;
}

void validate(lab::Settings& settings);

}  // namespace trammel::kung
