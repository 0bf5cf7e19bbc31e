// SPDX-License-Identifier: Apache-2.0
//
// A chip in which nothing happens, for tests of what is asked of a chip.
#pragma once

#include "cosim/machine_chip.hpp"

namespace trammel::test {

struct StillChip : cosim::MachineChip {
  cosim::Clk now() const override { return 0; }
  void sense(cosim::Lines) override {}
  void request(const cosim::BusOp&) override {}
  cosim::Stop run(cosim::Clk, const cosim::Plant&) override { return {}; }
  cosim::Lines drive() const override { return 0; }
  bool irq() const override { return false; }
  std::uint32_t rdata() const override { return 0; }
  cosim::Clk evaluated() const override { return 0; }
};

}  // namespace trammel::test
