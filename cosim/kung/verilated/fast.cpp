// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy.h>
#include <Vkung_xy___024root.h>

#include "cosim/kung/verilated/chip_model.hpp"

namespace trammel::kung {

std::unique_ptr<KungChip> make_verilated_chip(bool leap) {
  return std::make_unique<ChipModel<Vkung_xy, cosim::NoTrace>>(cosim::NoTrace{},
                                                               cosim::ModelMode{leap, false});
}

}  // namespace trammel::kung
