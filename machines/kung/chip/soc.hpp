// SPDX-License-Identifier: Apache-2.0
//
// The processor of rtl/chips/kung_soc.sv with the firmware in its memory, and what a loader does:
// it writes the set-up into the image before the core starts.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cosim/core.hpp"
#include "cosim/serial_host.hpp"
#include "sw_nios/apps/kung/kung.hpp"
#include "sw_nios/hal/mailbox.hpp"

namespace trammel::kung {

using CoreMemory = std::vector<std::uint32_t>;  // words

// The image of the firmware; empty: this program was built without the cross compiler.
const CoreMemory& core_image();

// Its memory with this set-up, which starts the path by itself if asked. Throws OptionsError where
// a list of points has no room.
CoreMemory core_memory(const sw::KungSetup& setup, bool start);

struct SocCore : cosim::Core {
  // What the program reports now; the core may be ahead of the chip by a few thousand clocks.
  virtual const sw::Mailbox& mailbox() const = 0;
  virtual void poke(std::uint32_t address, std::uint32_t word) = 0;
  virtual std::uint32_t peek(std::uint32_t address) const = 0;
  virtual void break_at(cosim::Clk edge) = 0;  // at its first interrupt from then on: an illegal
                                               // instruction
  virtual void connect(cosim::SerialHost& host) = 0;   // must live as long
  virtual bool listens() const = 0;                    // it has waited once: its start-up is over
  virtual cosim::Clk awake() const = 0;                // clocks that were evaluated
  // In an audit: where a clock in which the core was said to stand still changed something; "".
  virtual std::string moved() const = 0;
};

// nullptr: this program was built without the core's RTL. With `audit` every clock in which it is
// said to stand still is tried.
std::unique_ptr<SocCore> make_core(const CoreMemory& memory, bool audit);

}  // namespace trammel::kung
