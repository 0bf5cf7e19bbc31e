// SPDX-License-Identifier: Apache-2.0
#include <Vmcafee_checked.h>
#include <Vmcafee_checked___024root.h>
#include <Vmcafee_fast.h>
#include <Vmcafee_fast___024root.h>

#include <mcafee_xy_registers.hpp>
#include <mcafee_xy_traced.hpp>

#include "cosim/mcafee/verilated/chip_model.hpp"
#include "cosim/verilated/make_chip.hpp"

namespace trammel::mcafee {

std::unique_ptr<McafeeChip> make_verilated_chip(const cosim::RunBasics& run,
                                                const std::optional<cosim::WaveWindow>& window) {
  return cosim::make_chip<McafeeChip, ChipModel, Vmcafee_fast, Vmcafee_checked,
                          cosim::McafeeXyTraced, cosim::McafeeXyRegisters>(run, window);
}

}  // namespace trammel::mcafee
