// SPDX-License-Identifier: Apache-2.0
//
// What surrounds the chip gantry_tau, whoever evaluates it: the registers of its platform, the tick
// of the record, the converter and the non-volatile memory on its pins.
#pragma once

#include <algorithm>

#include "cosim/hosted.hpp"
#include "machines/gantry/chip.hpp"
#include "models/plant/mcp3008.hpp"
#include "sw_nios/apps/gantry/gantry_map.hpp"

namespace trammel::gantry {

// Pins of converter and memory, as the chip drives them.
struct Ports {
  bool cs_n = true, sclk = false, din = false;
  bool nv_valid = false, nv_write = false;
  unsigned nv_addr = 0;
  std::uint16_t nv_data = 0;
};

struct Board : cosim::HostedState {
  cosim::Clk sample_clk = 1;
  cosim::BusOp platform;
  bool platform_active = false;
  cosim::Lines lines = cosim::Lines{1} << kTx;  // toward the plant
  plant::Mcp3008 adc;
  bool dout = false;       // of the converter
  unsigned nv_addr = 0;    // whose word the memory shows
  Store store{};

  explicit Board(const ChipSetup& setup = {}) : sample_clk(setup.sample_clk), store(setup.store) {}

  bool samples(cosim::Clk edge) const {
    return (edge + 1) % sample_clk == 0 || (edge + 1) % kLook == 0;
  }
  cosim::Clk waiting(cosim::Clk edge) const {
    const auto left = [edge](cosim::Clk every) {
      return std::max<cosim::Clk>(1, every - 1 - edge % every);
    };
    return std::min({HostedState::waiting(edge), left(sample_clk), left(kLook)});
  }

  // Takes a transfer of the platform's own registers, which needs one clock; false: of the chip's.
  bool request(const cosim::BusOp& asked) {
    platform = asked;
    platform_active = asked.addr >= sw::gantry_map::kPlatform;
    return platform_active;
  }

  // Passes the edge of one of the platform, with the chip's interrupt after it.
  void platform_edge(cosim::Clk edge, bool chip_irq) {
    namespace map = sw::gantry_map;
    platform_active = false;
    if (platform.write) {
      if (platform.addr == map::kTimer) timer.write(edge, platform.data);
      return;
    }
    rdata = platform.addr != map::kIrq ? 0
                                       : (chip_irq ? map::kIrqChip : 0u) |
                                             (timer.irq() ? map::kIrqTimer : 0u);
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

  // The pins toward the plant after an edge; true when one changed.
  bool changed(cosim::Lines pins) {
    const bool moved = pins != lines;
    lines = pins;
    return moved;
  }
};

}  // namespace trammel::gantry
