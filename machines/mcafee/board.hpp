// SPDX-License-Identifier: Apache-2.0
//
// What stands around mcafee_xy, whoever evaluates it: the registers of its platform, and a
// converter an axis.
#pragma once

#include "cosim/hosted.hpp"
#include "machines/mcafee/lines.hpp"
#include "sw_nios/apps/mcafee/mcafee_map.hpp"

namespace trammel::mcafee {

struct Board : cosim::HostedState {
  cosim::BusOp platform;  // of its own registers
  bool platform_active = false;
  cosim::Lines codes = kZeroCode << converter(0) | kZeroCode << converter(1);

  // Takes a transfer of the platform's own registers, which needs one clock; false: of the chip's.
  bool request(const cosim::BusOp& op) {
    if (op.addr < sw::mcafee_map::kTimer) return false;
    platform = op;
    platform_active = true;
    return true;
  }

  // Passes the edge of one, with the chip's interrupt after it.
  void platform_edge(cosim::Clk edge, bool host_irq) {
    namespace map = sw::mcafee_map;
    platform_active = false;
    if (platform.write) {
      if (platform.addr == map::kTimer) timer.write(edge, platform.data);
      return;
    }
    rdata = platform.addr != map::kIrq ? 0
                                       : (host_irq ? map::kIrqHost : 0u) |
                                             (timer.irq() ? map::kIrqTimer : 0u);
  }

  // The codes of both converters after an edge; true when one changed.
  bool convert(cosim::Lines x, cosim::Lines y) {
    const cosim::Lines before = codes;
    codes = x << converter(0) | y << converter(1);
    return codes != before;
  }
};

}  // namespace trammel::mcafee
