// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cosim/cosim.hpp"

namespace trammel::test {

// Nothing moves; each converter reads its middle.
struct NoPlant final : cosim::Plant {
  cosim::Lines sense() const override { return 0; }
  cosim::Clk next() const override { return cosim::kNever; }
  void commit(cosim::Clk, cosim::Lines) override {}
  int sample(int, cosim::Clk) const override { return 2048; }
};

}  // namespace trammel::test
