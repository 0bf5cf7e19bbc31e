// SPDX-License-Identifier: Apache-2.0
//
// The soft processor: natively compiled firmware whose register accesses and interrupts cost time.
#pragma once

#include <tlm.h>
#include <tlm_utils/simple_initiator_socket.h>

#include <systemc>

#include "cosim/direct.hpp"
#include "sw_nios/hal/bus.hpp"
#include "systemc/chip_module.hpp"

namespace trammel::systemc {

class SoftProcessor final : public sc_core::sc_module, private sw::Bus {
 public:
  tlm_utils::simple_initiator_socket<SoftProcessor> bus;

  SoftProcessor(sc_core::sc_module_name name, ChipModule& chip, sw::Firmware& firmware,
                const cosim::ProcessorTiming& timing, std::int64_t period_ps);

 private:
  void execute();
  std::uint32_t read(std::uint32_t addr) override;
  void write(std::uint32_t addr, std::uint32_t data) override;
  void transfer(tlm::tlm_command command, std::uint32_t addr, std::uint32_t& data);

  ChipModule& chip_;
  sw::Firmware& firmware_;
  cosim::Clk now() const;
  sc_core::sc_time clocks(cosim::Clk count) const;

  cosim::ProcessorTiming timing_;
  std::int64_t period_ps_;
  tlm::tlm_generic_payload payload_;  // the stack of a process that is stopped is not unwound
};

}  // namespace trammel::systemc
