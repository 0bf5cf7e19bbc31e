// SPDX-License-Identifier: Apache-2.0
//
// What surrounds an LM628, model or twin: the master of its host port beside a timer,
// and a converter that takes 12 bits in two strobes.
#pragma once

#include <cstdint>

#include "cosim/hosted.hpp"
#include "parts/lm628/host_port.hpp"
#include "parts/lm628/lines.hpp"

namespace trammel::lm628 {

struct Board : cosim::HostedState {
  HostPort port;
  bool dac_wr_n = true;
  unsigned low_six = 0;
  cosim::Lines code = kZeroCode;

  // Passes an edge of a transfer, with the part's data and HI after it; true when it ended.
  bool bus_edge(cosim::Clk edge, std::uint8_t d, bool hi) {
    namespace map = sw::lm628_map;
    if (port.takes_data()) rdata = d;
    if (!port.advance()) return false;
    const cosim::BusOp& op = port.op();
    if (op.addr == map::kTimer && op.write) {
      timer.write(edge, op.data);
    } else if (op.addr == map::kIrq && !op.write) {
      rdata = (hi ? map::kIrqHost : 0u) | (timer.irq() ? map::kIrqTimer : 0u);
    }
    return true;
  }

  // The pins of the converter after an edge; true when its code changed.
  bool convert(unsigned dac, bool hi_lo, bool wr_n) {
    const bool strobe = wr_n && !dac_wr_n;
    dac_wr_n = wr_n;
    const unsigned six = dac >> 2;
    if (strobe && !hi_lo) low_six = six;
    const cosim::Lines next = six << 6 | low_six;
    if (!strobe || !hi_lo || next == code) return false;
    code = next;
    return true;
  }
};

}  // namespace trammel::lm628
