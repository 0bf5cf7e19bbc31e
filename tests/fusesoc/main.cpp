// SPDX-License-Identifier: Apache-2.0
//
// The simulation target of trammel.core: kung_xy answers a read of ID, with all gates off.
#include <Vkung_xy.h>
#include <verilated.h>

#include <cstdio>

#include "rtl/chips/generated/kung_xy_regs.hpp"

namespace {

void tick(Vkung_xy& chip) {
  chip.clk_i = 0;
  chip.eval();
  chip.clk_i = 1;
  chip.eval();
}

}  // namespace

int main() {
  Vkung_xy chip;
  chip.clock_en_i = 0x7FF;
  chip.s_axil_rready_i = 1;
  chip.s_axil_bready_i = 1;
  chip.rst_i = 1;
  for (int n = 0; n < 4; ++n) tick(chip);
  chip.rst_i = 0;
  chip.s_axil_araddr_i = trammel::kung_xy_regs::kId;
  chip.s_axil_arvalid_i = 1;
  for (int n = 0; n < 20; ++n) {
    const bool taken = chip.s_axil_arready_o != 0;
    if (chip.s_axil_rvalid_o != 0) {
      const bool off = chip.gate_hi_o == 0 && chip.gate_lo_o == 0;
      std::printf("ID %08x, gates %s\n", chip.s_axil_rdata_o, off ? "off" : "on");
      return off && chip.s_axil_rdata_o != 0 ? 0 : 1;
    }
    tick(chip);
    if (taken) chip.s_axil_arvalid_i = 0;
  }
  std::printf("no answer\n");
  return 1;
}
