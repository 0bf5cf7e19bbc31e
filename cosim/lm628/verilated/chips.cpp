// SPDX-License-Identifier: Apache-2.0
#include <Vlm628_checked.h>
#include <Vlm628_checked___024root.h>
#include <Vlm628_fast.h>
#include <Vlm628_fast___024root.h>

#include <lm628_registers.hpp>
#include <lm628_traced.hpp>

#include "cosim/lm628/verilated/chip_model.hpp"
#include "cosim/verilated/make_chip.hpp"

namespace trammel::lm628 {

std::unique_ptr<Lm628Chip> make_verilated_chip(const cosim::RunBasics& run,
                                               const std::optional<cosim::WaveWindow>& window) {
  return cosim::make_chip<Lm628Chip, ChipModel, Vlm628_fast, Vlm628_checked, cosim::Lm628Traced,
                          cosim::Lm628Registers>(run, window);
}

}  // namespace trammel::lm628
