// SPDX-License-Identifier: Apache-2.0
//
// Driver for McAfee's port (1994, ch. VI, bits as in his Stage I): a byte goes to or comes from one
// of two LM628 through port C, and port B says which, in which direction and when. Each rising
// strobe starts one pulse; the port must not change before it has ended. Freestanding.
#pragma once

#include <cstdint>

#include "rtl/chips/generated/mcafee_xy_regs.hpp"
#include "sw_nios/hal/bus.hpp"
#include "sw_nios/hal/lm628.hpp"

namespace trammel::sw {

// One of the two parts, as the bus that Lm628Port uses.
class McafeePart final : public Bus {
 public:
  // A pulse lasts 5.5 us, a poll more than 0.1 us.
  static constexpr std::uint32_t kPollLimit = 256;

  McafeePart(Bus& bus, bool y) : bus_(bus), axis_(y ? mcafee_xy_regs::kPortBY : 0) {}

  std::uint32_t read(std::uint32_t addr) override {
    pulse(addr, mcafee_xy_regs::kPortBRead, mcafee_xy_regs::kPortBReadStrobe);
    return bus_.read(mcafee_xy_regs::kPortC) & 0xFF;
  }

  void write(std::uint32_t addr, std::uint32_t data) override {
    bus_.write(mcafee_xy_regs::kPortC, data);
    pulse(addr, 0, mcafee_xy_regs::kPortBWriteStrobe);
  }

 private:
  void pulse(std::uint32_t addr, std::uint32_t direction, std::uint32_t strobe) {
    const std::uint32_t ps = addr == lm628_map::kData ? mcafee_xy_regs::kPortBPs : 0;
    const std::uint32_t selected = axis_ | ps | direction;
    bus_.write(mcafee_xy_regs::kPortB, selected);
    bus_.write(mcafee_xy_regs::kPortB, selected | strobe);
    for (std::uint32_t polls = 0; polls < kPollLimit; ++polls) {
      if ((bus_.read(mcafee_xy_regs::kStatus) & mcafee_xy_regs::kStatusBusy) == 0) return;
    }
  }

  Bus& bus_;
  std::uint32_t axis_;
};

}  // namespace trammel::sw
