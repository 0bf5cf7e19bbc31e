// SPDX-License-Identifier: Apache-2.0
//
// What surrounds an LM628, model or twin: the master of its host port beside a timer, and a
// converter that takes 12 bits in two strobes, or 8 as they are; or two wires to an H-bridge.
#pragma once

#include <cstdint>

#include "cosim/hosted.hpp"
#include "parts/lm628/host_port.hpp"
#include "parts/lm628/options.hpp"
#include "parts/lm628/pins.hpp"

namespace trammel::lm628 {

// The pins of a part toward its motor.
struct OutputPins {
  unsigned dac = 0;
  bool hi_lo = true, wr_n = true;
  bool magnitude = false, sign = false;
};

struct Surroundings : cosim::HostedState {
  HostPort port;
  PartOptions part;
  bool dac_wr_n = true;
  unsigned low_six = 0;
  cosim::Lines lines = kZeroCode;  // what drives the plant

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

  explicit Surroundings(const PartOptions& options = {}) : part(options) {
    if (part.pulses()) lines = 0;
  }

  // The pins after an edge; true when what drives the plant changed.
  bool output(const OutputPins& pins) {
    const cosim::Lines before = lines;
    if (part.pulses()) {
      lines = cosim::Lines{pins.magnitude} << kMagnitude | cosim::Lines{pins.sign} << kSign;
    } else if (part.dac_bits == 8) {
      // As it leaves its reset a part puts out 12 bits of zero, the low ones first.
      lines = pins.hi_lo ? cosim::Lines{pins.dac} << 4 : kZeroCode;
    } else {
      convert(pins);
    }
    return lines != before;
  }

 private:
  void convert(const OutputPins& pins) {
    const bool strobe = pins.wr_n && !dac_wr_n;
    dac_wr_n = pins.wr_n;
    const unsigned six = pins.dac >> 2;
    if (strobe && !pins.hi_lo) low_six = six;
    if (strobe && pins.hi_lo) lines = six << 6 | low_six;
  }
};

}  // namespace trammel::lm628
