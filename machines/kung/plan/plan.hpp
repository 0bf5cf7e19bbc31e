// SPDX-License-Identifier: Apache-2.0
//
// The plan of a run: all that follows from its options before the first clock.
#pragma once

#include "machines/kung/options.hpp"
#include "machines/kung/plan/path.hpp"
#include "machines/kung/plan/path_files.hpp"
#include "machines/kung/plan/walk.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::kung {

struct Plan {
  Plan() = default;
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  const ideal::Moves& moves() const { return store.feed.moves; }  // under the feed profile

  Options options;       // that it is made of
  PathFile file;
  PathStore store;
  sw::KungSetup setup;   // points into the store
  Walk walk;
};

}  // namespace trammel::kung
