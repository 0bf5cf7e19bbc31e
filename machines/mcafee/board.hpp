// SPDX-License-Identifier: Apache-2.0
//
// What stands around mcafee_xy, whoever evaluates it: its platform, and a converter an axis.
#pragma once

#include "cosim/processor_bus.hpp"
#include "machines/mcafee/lines.hpp"

namespace trammel::mcafee {

struct Board : cosim::ProcessorBus {
  Board() { lines = kZeroCode << converter(0) | kZeroCode << converter(1); }

  // The codes of both converters after an edge; true when one changed.
  bool convert(cosim::Lines x, cosim::Lines y) {
    return changed(x << converter(0) | y << converter(1));
  }
};

}  // namespace trammel::mcafee
