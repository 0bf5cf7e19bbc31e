// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy_checked.h>
#include <Vkung_xy_checked___024root.h>

#include "cosim/kung/verilated/chip_model.hpp"

namespace trammel::kung {

std::unique_ptr<KungChip> make_checked_chip() {
  return std::make_unique<ChipModel<Vkung_xy_checked, cosim::NoTrace>>(
      cosim::NoTrace{}, cosim::ModelMode{false, true});
}

}  // namespace trammel::kung
