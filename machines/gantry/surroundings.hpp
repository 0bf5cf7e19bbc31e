// SPDX-License-Identifier: Apache-2.0
//
// What surrounds the chip gantry_tau, whoever evaluates it: its platform, the converter and the
// non-volatile memory on its pins.
#pragma once

#include "cosim/processor_bus.hpp"
#include "machines/gantry/chip.hpp"
#include "models/plant/mcp3008.hpp"

namespace trammel::gantry {

struct Surroundings : cosim::ProcessorBus {
  plant::Mcp3008 adc;
  bool dout = false;       // of the converter
  unsigned nv_addr = 0;    // whose word the memory shows
  Store store{};

  explicit Surroundings(const ChipSetup& setup = {}) : store(setup.store) {
    ticks = {setup.sample_clk, kLook};
    lines = cosim::Lines{1} << kTx;
  }

  template <class In>
  void connect(In& in) const {
    in.nv_ready_i = true;
    in.adc_dout_i = false;
    in.nv_data_i = nv_word();
  }

  // The memory takes a word at an edge where it is ready, and it always is: `out` are the chip's
  // ports after the edge, so a write is of the next one, which nothing can keep from coming.
  template <class Out, class In, class Code>
  bool serve(const Out& out, In& in, Code&& code) {
    const bool bit = adc.step(out.adc_cs_n_o != 0, out.adc_sclk_o != 0, out.adc_din_o != 0, code);
    if (out.nv_valid_o && out.nv_write_o) store[out.nv_addr_o] = out.nv_data_o;
    const bool moved = bit != dout || out.nv_addr_o != nv_addr;
    dout = bit;
    nv_addr = out.nv_addr_o;
    if (moved) {
      in.adc_dout_i = dout;
      in.nv_data_i = nv_word();
    }
    return moved;
  }
  std::uint16_t nv_word() const { return store[nv_addr]; }
};

}  // namespace trammel::gantry
