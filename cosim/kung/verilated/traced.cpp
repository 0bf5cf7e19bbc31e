// SPDX-License-Identifier: Apache-2.0
#include <Vkung_xy.h>
#include <Vkung_xy___024root.h>
#include <Vkung_xy_checked.h>
#include <Vkung_xy_checked___024root.h>

#include <kung_xy_registers.hpp>
#include <kung_xy_traced.hpp>

#include "cosim/kung/verilated/chip_model.hpp"
#include "cosim/verilated/fst_trace.hpp"
#include "cosim/verilated/waved_chip.hpp"

namespace trammel::kung {

namespace {

using Trace = cosim::FstTrace<cosim::KungXyTraced>;

template <class Model>
using Waved = cosim::WavedChip<ChipModel<Model, cosim::NoTrace>, ChipModel<Vkung_xy_fst, Trace>,
                               cosim::KungXyRegisters>;

}  // namespace

std::unique_ptr<KungChip> make_traced_chip(const std::string& fst_file, const WaveWindow& window,
                                           bool leap, bool checked) {
  const cosim::ModelMode mode{leap, checked};
  if (checked) return std::make_unique<Waved<Vkung_xy_checked>>(mode, Trace(fst_file), window);
  return std::make_unique<Waved<Vkung_xy>>(mode, Trace(fst_file), window);
}

}  // namespace trammel::kung
