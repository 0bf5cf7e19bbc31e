// SPDX-License-Identifier: Apache-2.0
//
// What surrounds a chip without a bus: a processor's bus whose words are its pins
// (sw_nios/hal/pin_map.hpp), with a timer beside them, and a tick at which the record is taken.
#pragma once

#include <algorithm>
#include <cstdint>

#include "cosim/hosted.hpp"
#include "cosim/machine_chip.hpp"

namespace trammel::cosim {

// Such a chip, behind the loop's interface.
struct PinnedChip : MachineChip {
  virtual std::uint32_t word(std::uint32_t number) const = 0;  // as a read of it would see it now
};

struct PinBoard : HostedState {
  Clk sample_clk = 1;  // from one sample tick to the next
  BusOp op;
  bool active = false;  // a transfer, which takes one edge
  Lines lines = 0;      // toward the plant

  bool samples(Clk edge) const { return (edge + 1) % sample_clk == 0; }
  Clk waiting(Clk edge) const {
    return std::min(HostedState::waiting(edge),
                    std::max<Clk>(1, sample_clk - 1 - edge % sample_clk));
  }
};

}  // namespace trammel::cosim
