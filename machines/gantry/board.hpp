// SPDX-License-Identifier: Apache-2.0
//
// What surrounds the chip gantry_tau, whoever evaluates it: its platform, the converter and the
// non-volatile memory on its pins.
#pragma once

#include "cosim/processor_bus.hpp"
#include "machines/gantry/chip.hpp"
#include "models/plant/mcp3008.hpp"

namespace trammel::gantry {

// Pins of converter and memory, as the chip drives them.
struct Ports {
  bool cs_n = true, sclk = false, din = false;
  bool nv_valid = false, nv_write = false;
  unsigned nv_addr = 0;
  std::uint16_t nv_data = 0;
};

struct Board : cosim::ProcessorBus {
  plant::Mcp3008 adc;
  bool dout = false;       // of the converter
  unsigned nv_addr = 0;    // whose word the memory shows
  Store store{};

  explicit Board(const ChipSetup& setup = {}) : store(setup.store) {
    ticks = {setup.sample_clk, kLook};
    lines = cosim::Lines{1} << kTx;
  }

  // Before time 0 and after each evaluated edge. The memory takes a word at an edge where it is
  // ready, and it always is: `ports` are those after the edge, so a write is of the next one, which
  // nothing can keep from coming. `code(channel)` samples the plant. True when an input moves.
  template <class Code>
  bool serve(const Ports& ports, Code&& code) {
    const bool bit = adc.step(ports.cs_n, ports.sclk, ports.din, code);
    if (ports.nv_valid && ports.nv_write) store[ports.nv_addr] = ports.nv_data;
    const bool moved = bit != dout || ports.nv_addr != nv_addr;
    dout = bit;
    nv_addr = ports.nv_addr;
    return moved;
  }
  std::uint16_t nv_word() const { return store[nv_addr]; }
};

}  // namespace trammel::gantry
