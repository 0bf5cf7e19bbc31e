// SPDX-License-Identifier: Apache-2.0
//
// What stands around mcafee_xy, whoever evaluates it: its platform, and a converter an axis.
#pragma once

#include "cosim/processor_bus.hpp"
#include "machines/mcafee/lines.hpp"

namespace trammel::mcafee {

struct Board : cosim::ProcessorBus {
  Board() { lines = codes(kZeroCode, kZeroCode); }
};

}  // namespace trammel::mcafee
