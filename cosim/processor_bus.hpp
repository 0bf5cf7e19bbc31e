// SPDX-License-Identifier: Apache-2.0
//
// What is beside a chip on its processor's bus, whoever evaluates it: a timer, a register with the
// causes of the interrupt, a tick at which the record is taken, and the pins toward the plant.
#pragma once

#include <algorithm>
#include <array>

#include "cosim/hosted.hpp"
#include "sw_nios/hal/platform_map.hpp"

namespace trammel::cosim {

struct ProcessorBus : HostedState {
  std::array<Clk, 2> ticks{kNever, kNever};  // periods of what is recorded, from edge -1 on
  BusOp op;                                  // the last transfer, of the chip too
  bool platform_active = false;              // it is of the platform, and takes one edge
  Lines lines = 0;                           // toward the plant

  bool samples(Clk edge) const {
    return std::any_of(ticks.begin(), ticks.end(),
                       [edge](Clk every) { return (edge + 1) % every == 0; });
  }
  Clk waiting(Clk edge) const {
    Clk left = HostedState::waiting(edge);
    for (const Clk every : ticks) left = std::min(left, std::max<Clk>(1, every - 1 - edge % every));
    return left;
  }

  // Whether a transfer is of the platform.
  bool request(const BusOp& asked) {
    op = asked;
    platform_active = asked.addr >= sw::platform_map::kFirst;
    return platform_active;
  }

  // Passes the edge of one and ends it, with the chip's interrupt after it; false: there is none.
  bool platform_edge(Clk edge, bool chip_irq) {
    namespace map = sw::platform_map;
    if (!platform_active) return false;
    platform_active = false;
    if (!op.write) {
      rdata = op.addr != map::kIrq
                  ? 0
                  : (chip_irq ? map::kIrqChip : 0u) | (timer.irq() ? map::kIrqTimer : 0u);
    } else if (op.addr == map::kTimer) {
      timer.write(edge, op.data);
    }
    return true;
  }

  // What the chip's bus carries, where its words are not the processor's.
  BusOp placed() const { return op; }
  void answer(std::uint32_t data) { rdata = data; }

  // Converters and memories of a board on the chip's ports: their levels before time 0, and what
  // they do after each evaluated edge; true when one of the ports `in` moves. `code(channel)`
  // samples the plant.
  template <class In>
  void connect(In&) const {}
  template <class Out, class In, class Code>
  bool serve(const Out&, In&, Code&&) {
    return false;
  }

  // The pins toward the plant after an edge; true when one changed.
  bool changed(Lines pins) {
    const bool moved = pins != lines;
    lines = pins;
    return moved;
  }
};

}  // namespace trammel::cosim
