// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy.h>
#include <Vkung_xy___024root.h>

#include "cosim/kung/verilated/chip_model.hpp"

namespace trammel::kung {

namespace {
struct NoTrace {
  void attach(VerilatedContext&, Vkung_xy&) {}
  void edge(cosim::Clk, bool) {}
};
}  // namespace

std::unique_ptr<KungChip> make_verilated_chip() {
  return std::make_unique<ChipModel<Vkung_xy, NoTrace>>(NoTrace{});
}

}  // namespace trammel::kung
