// SPDX-License-Identifier: Apache-2.0
//
// What surrounds a chip without a bus: a processor's bus whose words are its pins
// (sw_nios/hal/pin_map.hpp), with the platform's timer beside them, and a tick at which the record
// is taken.
#pragma once

#include <cstdint>

#include "cosim/machine_chip.hpp"
#include "cosim/processor_bus.hpp"

namespace trammel::cosim {

// Such a chip, behind the loop's interface.
struct PinnedChip : MachineChip {
  virtual std::uint32_t word(std::uint32_t number) const = 0;  // as a read of it would see it now
};

struct PinBus : ProcessorBus {
  bool pins_active = false;  // a transfer of them, which takes one edge
};

}  // namespace trammel::cosim
