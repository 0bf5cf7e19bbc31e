// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy.h>
#include <Vkung_xy___024root.h>

#include <kung_xy_registers.hpp>

#include "cosim/kung/verilated/chip_model.hpp"
#include "cosim/verilated/in_step.hpp"

namespace trammel::kung {

std::unique_ptr<KungChip> make_audited_chip() {
  using Chip = ChipModel<Vkung_xy, cosim::NoTrace>;
  return std::make_unique<cosim::AuditedChip<Chip, cosim::KungXyRegisters>>();
}

}  // namespace trammel::kung
