// SPDX-License-Identifier: Apache-2.0
//
// The verilated chip that a run asks for, of the models of one chip.
#pragma once

#include <memory>

#include "cosim/machine.hpp"
#include "cosim/verilated/in_step.hpp"

namespace trammel::cosim {

// Fast: for speed; Checked: with the promises of its blocks.
template <class Interface, template <class Model, class Tracer> class ChipModel, class Fast,
          class Checked, class Registers>
std::unique_ptr<Interface> make_chip(const RunBasics& run) {
  using Untraced = ChipModel<Fast, NoTrace>;
  if (run.audit) return std::make_unique<AuditedChip<Untraced, Registers>>();
  const ModelMode mode{run.leap, run.assertions};
  if (run.assertions) return std::make_unique<ChipModel<Checked, NoTrace>>(NoTrace{}, mode);
  return std::make_unique<Untraced>(NoTrace{}, mode);
}

}  // namespace trammel::cosim
