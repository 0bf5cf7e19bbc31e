// SPDX-License-Identifier: Apache-2.0
//
// What surrounds larson_xy, whoever evaluates it: the registers of its platform, the tick of the
// record, and the bridge between a processor whose every access is of 32 bits and the words of 16
// bits: each has an address of its own there, and is half of the chip's bus, as its bytes have.
#pragma once

#include <algorithm>

#include "cosim/hosted.hpp"
#include "machines/larson/chip.hpp"
#include "sw_nios/apps/larson/larson_map.hpp"

namespace trammel::larson {

struct Board : cosim::HostedState {
  cosim::Clk sample_clk = 1;
  cosim::BusOp op;
  bool platform_active = false;
  cosim::Lines lines = 0;  // toward the plant

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
    op = asked;
    platform_active = asked.addr >= sw::larson_map::kPlatform;
    return platform_active;
  }

  // Of a transfer of the chip: its bytes, and address and data in their place.
  bool half() const { return op.addr < sw::larson_map::kVector; }
  bool byte() const { return op.addr >= sw::larson_map::kBytes; }
  int shift() const {
    if (byte()) return static_cast<int>(op.addr / 4 & 3) * 8;
    return half() && (op.addr & 4) != 0 ? 16 : 0;
  }
  unsigned bytes() const { return (byte() ? 1u : half() ? 3u : 15u) << shift() / 8; }
  cosim::BusOp placed() const {
    const std::uint32_t addr = byte() ? op.addr / 4 : op.addr / 2;
    return {(byte() ? addr & 4u : addr & ~3u), op.data << shift(), op.write};
  }
  void answer(std::uint32_t data) {
    rdata = byte() ? data >> shift() & 0xFF : half() ? data >> shift() & 0xFFFF : data;
  }

  // Passes the edge of one of the platform, with the chip's interrupt after it.
  void platform_edge(cosim::Clk edge, bool chip_irq) {
    namespace map = sw::larson_map;
    platform_active = false;
    if (op.write) {
      if (op.addr == map::kTimer) timer.write(edge, op.data);
      return;
    }
    rdata = op.addr != map::kIrq ? 0
                                 : (chip_irq ? map::kIrqChip : 0u) |
                                       (timer.irq() ? map::kIrqTimer : 0u);
  }

  // The pins toward the plant after an edge; true when one changed.
  bool changed(cosim::Lines pins) {
    const bool moved = pins != lines;
    lines = pins;
    return moved;
  }
};

}  // namespace trammel::larson
