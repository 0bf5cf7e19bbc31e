// SPDX-License-Identifier: Apache-2.0
//
// Interface of firmware to the machine: a 32-bit register bus and the entry points of an
// application.
// Freestanding: no heap, no iostream.
#pragma once

#include <cstdint>

#include "sw_nios/hal/mailbox.hpp"

namespace trammel::sw {

struct Bus {
  virtual std::uint32_t read(std::uint32_t addr) = 0;  // byte address
  virtual void write(std::uint32_t addr, std::uint32_t data) = 0;

 protected:
  ~Bus() = default;
};

// Runs to completion: no stack survives a wait. On a core: start(); for (;;) { wait; isr(); }
struct Firmware {
  virtual void start(Bus& bus) = 0;
  virtual void isr(Bus& bus) = 0;
  virtual const Mailbox& mailbox() const = 0;

 protected:
  ~Firmware() = default;
};

}  // namespace trammel::sw
