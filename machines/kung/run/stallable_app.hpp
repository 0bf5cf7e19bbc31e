// SPDX-License-Identifier: Apache-2.0
//
// The application, but while the processor hangs: then its routine only reads.
#pragma once

#include "cosim/fault.hpp"
#include "rtl/chips/generated/kung_xy_regs.hpp"
#include "sw_nios/apps/kung/kung.hpp"

namespace trammel::kung {

class StallableApp final : public sw::Firmware {
 public:
  StallableApp(const sw::KungSetup& setup, const cosim::Chip& chip,
               const cosim::FaultSpan& hung = {})
      : app_(setup), chip_(chip), hung_(hung) {}

  void start(sw::Bus& bus) override { app_.start(bus); }
  void isr(sw::Bus& bus) override {
    if (hung_.holds(chip_.now())) {
      bus.read(kung_xy_regs::kId);
    } else {
      app_.isr(bus);
    }
  }
  const sw::KungMailbox& mailbox() const override { return app_.mailbox(); }

 private:
  sw::KungApp app_;
  const cosim::Chip& chip_;
  cosim::FaultSpan hung_;
};

}  // namespace trammel::kung
